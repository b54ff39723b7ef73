// The checks of what components will read, one function for each kind of
// component.
#include "tools/parlour/application/resource_check.hpp"

#include <algorithm>
#include <functional>
#include <set>
#include <utility>

#include "adapters/database/mariadb/mariadb_options.hpp"
#include "adapters/database/sqlite/sqlite_image.hpp"
#include "adapters/database/sqlite/sqlite_options.hpp"
#include "adapters/http/http_service.hpp"
#include "adapters/mqtt/device_list.hpp"
#include "adapters/mqtt/mqtt_options.hpp"
#include "adapters/nlu/keywords/keyword_nlu.hpp"
#include "runtime/base/file_bytes.hpp"
#include "tools/parlour/application/understanding.hpp"

namespace parlour::tools {

namespace {

using script::Severity;

// Adds an error. One without a place of its own is reported at the component.
void report(Application& application, const Error& error,
            const SourceLocation& otherwise, const std::string& component) {
  const auto has_place = !error.place.file.empty();
  auto place = has_place ? error.place : otherwise;
  // Editors expect columns to count from 1; 0 means unknown.
  place.column = std::max(place.column, 1u);
  application.findings.push_back(
      {Severity::error, std::move(place),
       has_place ? error.message : component + ": " + error.message});
}

// False if an option has the wrong type, which composition.cpp has reported
// already.
bool options_fit(const ChosenComponent& component) {
  const auto& all = component.factory.description.options;
  return std::ranges::all_of(all, [&](const OptionDescription& option) {
    const auto given = component.options.find(option.name);
    return given == component.options.end() ||
           check_option(option, given->second);
  });
}

// SQLite: runs schema and seed in memory.
void check_database(Application& application,
                    const ChosenComponent& component) {
  // The data folder is not known yet. Any folder will do, because nothing is
  // opened in it.
  const auto options = adapters::read_sqlite_options(
      component.options, application.folder.string(),
      application.folder.string());
  if (!options)
    return report(application, options.error(), component.place,
                  component.name);
  const auto image = adapters::sqlite_image(options->schema, options->seed);
  if (!image)
    report(application, image.error(), component.place, component.name);
}

// Only the files are read: a check must work without the server.
void check_server_database(Application& application,
                           const ChosenComponent& component) {
  const auto options = adapters::read_mariadb_options(
      component.options, application.folder.string());
  if (!options)
    return report(application, options.error(), component.place,
                  component.name);
  for (const auto* file : {&options->schema, &options->seed}) {
    if (file->empty())
      continue;
    if (const auto text = read_file(*file); !text)
      report(application, text.error(), component.place, component.name);
  }
}

// Options that name a file of the application which a component reads when it
// starts. A missing file is a warning.
struct FileOption {
  const char* plugin;
  const char* option;
};
constexpr FileOption file_options[] = {{"LogWeather", "reports"},
                                       {"LogTraffic", "reports"},
                                       {"LogDevices", "devices"},
                                       {"MQTTDevices", "devices"}};

// Warns of files that an option names and that do not exist.
void check_files(Application& application, const ChosenComponent& component) {
  for (const auto& [plugin, option] : file_options) {
    const auto given = component.options.find(option);
    std::error_code ignored;
    if (component.factory.description.name != plugin ||
        given == component.options.end() || given->second.empty() ||
        std::filesystem::is_regular_file(application.folder / given->second,
                                         ignored))
      continue;
    auto place = component.place;
    place.column = std::max(place.column, 1u);
    application.findings.push_back({Severity::warning, std::move(place),
                                    component.name + ": there is no file '" +
                                        given->second +
                                        "', which the option '" + option +
                                        "' names, in the application's folder",
                                    "missing-file"});
  }
}

// HTTPService: reads its file of rules; the service itself is not asked.
void check_rules(Application& application, const ChosenComponent& component) {
  const auto mistakes = adapters::http::check_service(
      component.options, application.folder.string());
  for (const auto& error : mistakes.errors)
    report(application, error, component.place, component.name);
  for (const auto& missing : mistakes.missing)
    application.findings.push_back(
        {Severity::warning, missing.place, missing.message, "missing-secret"});
}

// The list of devices is read, the server is not asked. A file that is missing
// has been reported.
void check_devices(Application& application, const ChosenComponent& component) {
  const auto options = adapters::mqtt::read_mqtt_options(
      component.options, application.folder.string());
  if (!options)
    return report(application, options.error(), component.place,
                  component.name);
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(options->devices, ignored))
    return;
  if (const auto list = adapters::mqtt::DeviceList::read(options->devices);
      !list)
    report(application, list.error(), component.place, component.name);
}

// Checks all databases. False if one of them has wrong options.
bool check_databases(Application& application) {
  bool fit = true;
  for (const auto& component : application.composition.components) {
    const auto& plugin = component.factory.description.name;
    const auto check = plugin == "SQLiteDatabase"  ? check_database
                       : plugin == "MySQLDatabase" ? check_server_database
                                                   : nullptr;
    if (check && !options_fit(component))
      fit = false;
    else if (check)
      check(application, component);
  }
  return fit;
}

// Reports columns that cannot be read where they are named. The returned reader
// treats them as empty, so that the understanding does not report them again.
ColumnReader check_columns(Application& application,
                           const std::vector<NamedColumn>& columns) {
  const auto reader =
      column_reader(in_memory(application.composition), application.folder, "");
  std::set<std::string> unreadable;
  for (const auto& [name, place] : columns)
    if (const auto values = reader(name); !values) {
      application.findings.push_back(
          {Severity::error, place, values.error().message});
      unreadable.insert(name);
    }
  return [reader, unreadable](
             const std::string& name) -> Expected<std::vector<std::string>> {
    if (unreadable.count(name) > 0)
      return std::vector<std::string>();
    return reader(name);
  };
}

// GrammarNLU: builds the understanding with its grammars and examples.
void check_understanding(Application& application,
                         const ChosenComponent& component,
                         const ColumnReader& columns) {
  const auto built = build_engine(application, component, columns);
  if (!built)
    for (const auto& error : built.error())
      report(application, error, component.place, component.name);
}

// KeywordNLU: reads its file of rules.
void check_keywords(Application& application, const ChosenComponent& component,
                    const ColumnReader& columns) {
  const auto read = adapters::load_keyword_rules(
      component.options, application.folder.string(),
      *application.program->understanding, columns);
  if (!read)
    for (const auto& error : read.error())
      report(application, error, component.place, component.name);
}

} // namespace

// Collects the attribute `source` of every <cardinality>, recursively.
std::vector<NamedColumn> columns_of_slots(const script::Compiled& compiled) {
  std::vector<NamedColumn> columns;
  const std::function<void(const script::Element&)> look =
      [&](const script::Element& element) {
        const auto* source = element.attribute("source");
        if (element.is("cardinality") && source)
          columns.push_back(
              {source->value, compiled.findings.place(source->value_position)});
        for (const auto& child : element.children)
          look(child);
      };
  for (const auto& document : compiled.documents)
    look(document.root);
  return columns;
}

void check_resources(Application& application,
                     const std::vector<NamedColumn>& columns) {
  const auto before = application.findings.size();
  const auto& composition = application.composition;
  const bool fit = check_databases(application);
  const auto failed = application.findings.size();
  for (const auto& component : composition.components) {
    check_files(application, component);
    if (component.factory.description.name == "HTTPService")
      check_rules(application, component);
    if (component.factory.description.name == "MQTTDevices" &&
        options_fit(component))
      check_devices(application, component);
  }
  // If a database cannot be made, reading its columns would report the same
  // again.
  if (!application.program || !fit || failed > before)
    return;
  const auto reader = check_columns(application, columns);
  for (const auto& component : composition.components)
    if (component.factory.description.name == "GrammarNLU")
      check_understanding(application, component, reader);
    else if (component.factory.description.name == "KeywordNLU")
      check_keywords(application, component, reader);
}

} // namespace parlour::tools
