#include "tools/parlour/application/plugins/shipped_plugin.hpp"

#include <algorithm>
#include <cstdlib>

#include "adapters/asr/moonshine_place.hpp"
#include "adapters/audio/file_microphone.hpp"
#include "adapters/audio/file_speaker.hpp"
#include "adapters/database/mariadb/connection/mariadb_options.hpp"
#include "adapters/database/mariadb/mariadb_columns.hpp"
#include "adapters/database/sqlite/sqlite_columns.hpp"
#include "adapters/database/sqlite/sqlite_image.hpp"
#include "adapters/database/sqlite/sqlite_options.hpp"
#include "adapters/http/http_service.hpp"
#include "adapters/mqtt/device_list.hpp"
#include "adapters/mqtt/mqtt_options.hpp"
#include "adapters/nlu/keywords/keyword_nlu.hpp"
#include "adapters/nlu/understand/grammar_nlu.hpp"
#include "adapters/push_to_talk/key_push_to_talk.hpp"
#include "adapters/standins/log_devices.hpp"
#include "runtime/base/outside/file_bytes.hpp"
#include "tools/parlour/application/plugins/catalogue.hpp"

namespace parlour::tools {

namespace {

namespace fs = std::filesystem;

template <class T>
void add_error(Mistakes& mistakes, const Expected<T>& result) {
  if (!result)
    mistakes.errors.push_back(result.error());
}

template <class T>
std::vector<Error>
errors_of(const tl::expected<T, std::vector<Error>>& result) {
  return result ? std::vector<Error>() : result.error();
}

// -- SQLiteDatabase -----------------------------------------------------------

void forget_file(PluginFactory&, Options& options) {
  options.erase("file");
}

// Runs schema and seed in memory. Any folder will do for the data, because
// nothing is opened in it.
Mistakes check_sqlite(const Options& options, const fs::path& application) {
  Mistakes mistakes;
  const auto read = adapters::read_sqlite_options(options, application.string(),
                                                  application.string());
  add_error(mistakes, read);
  if (read)
    add_error(mistakes, adapters::sqlite_image(read->schema, read->seed));
  return mistakes;
}

ColumnReader sqlite_columns(const Options& options, const fs::path& application,
                            const std::string& data_folder) {
  return adapters::sqlite_column_reader(options, data_folder,
                                        application.string());
}

fs::path sqlite_file(const Options& options, const fs::path& application,
                     const std::string& data_folder) {
  const auto read =
      adapters::read_sqlite_options(options, data_folder, application.string());
  return read && !read->schema.empty() ? read->file : fs::path();
}

// -- MySQLDatabase ------------------------------------------------------------

void use_copy(PluginFactory&, Options& options) {
  options["copy"] = "true";
}

// A check must work without the server, so the files are only read.
Mistakes check_mariadb(const Options& options, const fs::path& application) {
  Mistakes mistakes;
  const auto read =
      adapters::read_mariadb_options(options, application.string());
  add_error(mistakes, read);
  if (read)
    for (const auto& file : {read->schema, read->seed})
      if (!file.empty())
        add_error(mistakes, read_file(file));
  return mistakes;
}

ColumnReader mariadb_columns(const Options& options,
                             const fs::path& application, const std::string&) {
  return adapters::mariadb_column_reader(options, application.string());
}

// -- services and devices -----------------------------------------------------

void describe_service(PluginDescription& plugin, const Options& options,
                      const fs::path& application) {
  adapters::http::describe_by_rules(plugin, options, application.string());
}

// The samples of its rules answer.
void answer_by_samples(PluginFactory&, Options& options) {
  options["samples"] = "true";
}

Mistakes check_rules(const Options& options, const fs::path& application) {
  auto found = adapters::http::check_service(options, application.string());
  return {std::move(found.errors), std::move(found.missing)};
}

// The same devices, on paper: both read the same list of them. It goes by the
// name of what it stands for, so that <load> finds the component's options.
void stand_in_for_devices(PluginFactory& factory, Options& options) {
  const auto name = factory.description.name;
  factory = adapters::log_devices_factory();
  factory.description.name = name;
  std::erase_if(options,
                [](const auto& option) { return option.first != "devices"; });
}

// A list that is missing is told as a missing file.
Mistakes check_devices(const Options& options, const fs::path& application) {
  Mistakes mistakes;
  const auto read =
      adapters::mqtt::read_mqtt_options(options, application.string());
  add_error(mistakes, read);
  std::error_code ignored;
  if (read && fs::is_regular_file(read->devices, ignored))
    add_error(mistakes, adapters::mqtt::DeviceList::read(read->devices));
  return mistakes;
}

// A terminal may be somebody's, and conversations are tried side by side.
void press_no_key(PluginFactory& factory, Options&) {
  factory = adapters::unpressed_key_factory();
}

bool is_key_of_terminal(const Options& options) {
  const auto device = options.find("device");
  return device == options.end() || device->second.empty();
}

// -- voice --------------------------------------------------------------------

bool is_moonshine_installed() {
  const auto* const path = std::getenv("PATH");
  return adapters::moonshine::find_place(
             {{}, moonshine_programs(), "node", path ? path : ""})
      .has_value();
}

// -- understanding ------------------------------------------------------------

std::vector<Error> check_grammars(const Options& options,
                                  const fs::path& application,
                                  const UnderstandingModel& model,
                                  const ColumnReader& columns) {
  return errors_of(adapters::nlu::build_engine(options, model, columns,
                                               application.string()));
}

std::vector<Error> check_keywords(const Options& options,
                                  const fs::path& application,
                                  const UnderstandingModel& model,
                                  const ColumnReader& columns) {
  return errors_of(adapters::load_keyword_rules(options, application.string(),
                                                model, columns));
}

// -- the table ----------------------------------------------------------------

constexpr std::string_view typed = "turns are typed instead of spoken";
constexpr std::string_view shown = "text is shown instead of spoken";

const std::vector<ShippedPlugin>& all() {
  static const std::vector<ShippedPlugin> table = {
      {.name = "SQLiteDatabase",
       .rehearse = forget_file,
       .check_files = check_sqlite,
       .columns = sqlite_columns,
       .kept_file = sqlite_file,
       .speaks_sqlite = true},
      {.name = "MySQLDatabase",
       .rehearse = use_copy,
       .check_files = check_mariadb,
       .columns = mariadb_columns},
      {.name = "HTTPService",
       .describe = describe_service,
       .rehearse = answer_by_samples,
       .check_files = check_rules},
      {.name = "MQTTDevices",
       .file_options = {"devices"},
       .rehearse = stand_in_for_devices,
       .check_files = check_devices},
      {.name = "KeyPushToTalk",
       .rehearse = press_no_key,
       .takes_terminal = is_key_of_terminal},
      {.name = "LogDevices", .file_options = {"devices"}},
      {.name = "LogWeather", .file_options = {"reports"}},
      {.name = "LogTraffic", .file_options = {"reports"}},
      {.name = "FileMicrophone", .for_file = adapters::file_microphone_factory},
      {.name = "FileSpeaker", .for_file = adapters::file_speaker_factory},
      {.name = "AlsaMicrophone", .without = typed},
      {.name = "AlsaSpeaker", .without = "text is shown instead of played"},
      {.name = "EspeakTTS", .without = shown},
      {.name = "FliteTTS", .without = shown},
      {.name = "MoonshineASR",
       .without = typed,
       .is_installed = is_moonshine_installed},
      {.name = "SphinxASR", .without = typed},
      {.name = "WebRtcEnhancement", .without = "audio is heard as it is"},
      {.name = "GrammarNLU",
       .check_understanding = check_grammars,
       .try_examples = adapters::nlu::try_examples},
      {.name = "KeywordNLU", .check_understanding = check_keywords},
  };
  return table;
}

} // namespace

const ShippedPlugin& shipped_plugin(std::string_view name) {
  static const ShippedPlugin unknown;
  const auto found = std::ranges::find(all(), name, &ShippedPlugin::name);
  return found == all().end() ? unknown : *found;
}

bool is_installed(std::string_view name) {
  const auto asks = shipped_plugin(name).is_installed;
  return !asks || asks();
}

void complete_description(PluginDescription& plugin, const Options& options,
                          const fs::path& application) {
  if (const auto describe = shipped_plugin(plugin.name).describe)
    describe(plugin, options, application);
}

void rehearse(PluginFactory& factory, Options& options) {
  if (const auto change = shipped_plugin(factory.description.name).rehearse)
    change(factory, options);
}

} // namespace parlour::tools
