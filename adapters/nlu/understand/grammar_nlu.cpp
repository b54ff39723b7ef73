// The plug-in around NluEngine: it reads the options, builds the engine at its
// start, and passes each text on. It is an inline component (engine rule 1.2):
// no engine changes. Where a column has new values, another engine takes its
// place, and whoever asks meanwhile is answered by the one before.
#include "adapters/nlu/understand/grammar_nlu.hpp"

#include <algorithm>
#include <memory>
#include <mutex>
#include <utility>

#include "adapters/nlu/grammar/example_file.hpp"
#include "adapters/nlu/understand/engine_store.hpp"
#include "adapters/nlu/understand/language_knowledge.hpp"
#include "adapters/nlu/values/known_columns.hpp"
#include "runtime/base/outside/file_bytes.hpp"
#include "runtime/plugin/adaptors.hpp"
#include "runtime/plugin/folder.hpp"

namespace parlour::adapters {

namespace {

// Also the source of the defaults.
const std::vector<OptionDescription>& option_descriptions() {
  static const std::vector<OptionDescription> descriptions{
      {"threshold", "0.4",
       "acts with a lower score are not understood, from 0 to 1", false,
       OptionType::number},
      {"examples", "",
       "a file of the application with further examples, a topic, a tab and a "
       "text in each line"},
      {"generic", "",
       "the application's grammar of generic acts, instead of the platform's"},
      {"platform", "", "folder of what the platform ships"}};
  return descriptions;
}

std::string option(const Options& options, const std::string& name) {
  return option_value(options, option_descriptions(), name);
}

bool is_of_data(const Error& error) {
  return error.kind == ErrorKind::database || error.kind == ErrorKind::file;
}

// Joins errors to one with a line for each. An error of data stands alone: if
// the database cannot be read, all others follow from that.
Error joined(const std::vector<Error>& errors) {
  const auto data = std::ranges::find_if(errors, is_of_data);
  if (data != errors.end())
    return *data;
  auto all = errors.front();
  for (std::size_t at = 1; at < errors.size(); ++at) {
    const auto& error = errors[at];
    all.message += '\n';
    if (!error.place.file.empty())
      all.message += error.place.file + ':' + std::to_string(error.place.line) +
                     ':' + std::to_string(error.place.column) + ": ";
    all.message += error.message;
  }
  return all;
}

class GrammarNLU : public NLUPlugin {
protected:
  // Times such as "in ten minutes" need the present time. If the context does
  // not give it, the platform's clock does.
  std::vector<Value> understand(const std::string& text,
                                const Map& given) const override {
    auto context = given;
    if (!context.find("now"))
      context.set("now", host().clock().now());
    return engine().understand(text, std::move(context)).acts;
  }

  void set_values(const std::string& column,
                  const List& values) const override {
    const std::lock_guard one_after_the_other(changing_);
    if (!columns_.set(column, values))
      return;
    auto built = build();
    if (!built)
      return host().log("The new values of " + column +
                        " are not used: " + built.error().message);
    const std::lock_guard lock(mutex_);
    engine_ = std::move(*built);
  }

  Expected<void> on_start(const Options& options) override {
    for (const auto& described : option_descriptions())
      if (auto fits = check_option(described, option(options, described.name));
          !fits)
        return fits;
    options_ = options;
    auto built = build();
    if (!built)
      return tl::make_unexpected(built.error());
    engine_ = std::move(*built);
    return {};
  }

private:
  Expected<nlu::NluEngine> build() const {
    const auto model = host().understanding();
    auto built = nlu::build_engine(
        options_, model ? *model : UnderstandingModel(),
        [this](const std::string& name) {
          return columns_.read(name, [this](const std::string& column) {
            return host().column(column);
          });
        },
        host().application_folder());
    if (!built)
      return tl::make_unexpected(joined(built.error()));
    return std::move(*built);
  }

  nlu::NluEngine engine() const {
    const std::lock_guard lock(mutex_);
    return *engine_;
  }

  Options options_;
  // New values may come in the turns of several sessions.
  mutable std::mutex changing_; // guards the columns
  mutable nlu::KnownColumns columns_;
  mutable std::mutex mutex_;
  mutable std::optional<nlu::NluEngine> engine_; // from the start on
};

} // namespace

namespace nlu {

Expected<GrammarModel> read_grammar(const std::string& path) {
  auto text = read_file(path);
  if (!text)
    return tl::make_unexpected(text.error());
  // "config/taxi.jsgf" is the grammar "taxi".
  const auto slash = path.find_last_of('/');
  auto name = slash == std::string::npos ? path : path.substr(slash + 1);
  return GrammarModel{
      name.substr(0, name.find('.')), std::move(*text), {path, 1, 1}};
}

namespace {

// The grammar of generic acts.
Expected<GrammarModel> read_generic(const Options& options,
                                    const std::string& application_folder) {
  const auto own = option(options, "generic");
  const auto platform = option(options, "platform");
  if (!own.empty())
    return inside(application_folder, own, "generic")
        .and_then([](const auto& path) { return read_grammar(path.string()); });
  if (platform.empty())
    return fail(ErrorKind::settings, "GrammarNLU: neither the option "
                                     "'platform' nor 'generic' is set");
  return read_grammar(platform + "/generic-acts.jsgf");
}

void read_threshold(const Options& options, double& threshold,
                    std::vector<Error>& errors) {
  const auto given = option(options, "threshold");
  // The settings have been checked: the option is a number.
  threshold = parse_number(given).number_or(threshold);
  if (threshold < 0 || threshold > 1)
    errors.push_back(
        {ErrorKind::settings,
         "the option 'threshold' takes a number from 0 to 1, not '" + given +
             "'",
         {}});
}

// None where an application has a generic grammar of its own and no platform.
std::vector<SynonymGroup> platform_synonyms(const Options& options,
                                            std::vector<Error>& errors) {
  const auto platform = option(options, "platform");
  if (platform.empty())
    return {};
  const auto text = read_file(platform + "/synonyms.txt");
  if (text)
    return read_synonyms(*text);
  errors.push_back(text.error());
  return {};
}

// Adds the examples of a file to those of the topics.
void read_examples(const Options& options,
                   const std::string& application_folder,
                   UnderstandingModel& model, std::vector<Error>& errors) {
  const auto name = option(options, "examples");
  if (name.empty())
    return;
  const auto path = inside(application_folder, name, "examples");
  if (!path)
    return errors.push_back(path.error());
  for (auto& error : add_example_file(*path, model))
    errors.push_back(std::move(error));
}

} // namespace

tl::expected<NluEngine::Options, std::vector<Error>>
read_platform(const Options& options, const std::string& application_folder) {
  std::vector<Error> errors;
  NluEngine::Options read;
  read_threshold(options, read.threshold, errors);
  if (auto generic = read_generic(options, application_folder))
    read.generic = {std::move(*generic)};
  else
    errors.push_back(generic.error());
  read.synonyms = platform_synonyms(options, errors);
  if (const auto platform = option(options, "platform"); !platform.empty())
    read.language = language_store().read(platform, errors);
  if (!errors.empty())
    return tl::make_unexpected(std::move(errors));
  return read;
}

tl::expected<NluEngine, std::vector<Error>>
build_engine(const Options& options, UnderstandingModel model,
             const ColumnReader& columns,
             const std::string& application_folder) {
  // Everything is read even after an error, so that all errors are reported at
  // once.
  std::vector<Error> errors;
  auto platform = read_platform(options, application_folder);
  if (!platform)
    errors = platform.error();
  read_examples(options, application_folder, model, errors);
  auto built = engine_store().get(
      model, platform ? std::move(*platform) : NluEngine::Options(), columns);
  if (!built)
    errors.insert(errors.end(), built.error().begin(), built.error().end());
  if (!errors.empty())
    return tl::make_unexpected(std::move(errors));
  return built;
}

std::vector<LeftOutExample>
try_examples(const Options& options, UnderstandingModel model,
             const ColumnReader& columns,
             const std::string& application_folder) {
  std::vector<Error> errors;
  const auto platform = read_platform(options, application_folder);
  read_examples(options, application_folder, model, errors);
  if (!platform || !errors.empty())
    return {};
  return read_left_out(model, columns, *platform);
}

} // namespace nlu

PluginFactory grammar_nlu_factory() {
  PluginDescription description;
  description.name = "GrammarNLU";
  description.roles = {"NLU"};
  description.sentence = "understands by grammars, examples, names and values";
  description.options = option_descriptions();
  description.is_inline = true;
  return {std::move(description),
          [] { return std::make_unique<GrammarNLU>(); }};
}

} // namespace parlour::adapters
