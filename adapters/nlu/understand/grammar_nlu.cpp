// The plug-in around NluEngine: it reads the options, builds the engine at its
// start, and passes each text on. It is an inline component (engine rule 1.2):
// no engine changes.
#include "adapters/nlu/understand/grammar_nlu.hpp"

#include <memory>
#include <utility>

#include "adapters/nlu/grammar/example_file.hpp"
#include "adapters/nlu/text/lines.hpp"
#include "adapters/nlu/understand/engine_store.hpp"
#include "adapters/nlu/understand/language_knowledge.hpp"
#include "adapters/nlu/values/renewed_nlu.hpp"
#include "runtime/base/outside/file_bytes.hpp"
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
      {"wordings", "",
       "a file of the application with what people say: topic and slots, a tab "
       "and a text in each line"},
      {"generic", "",
       "the application's grammar of generic acts, instead of the platform's"},
      {"platform", "", "folder of what the platform ships"}};
  return descriptions;
}

std::string option(const Options& options, const std::string& name) {
  return option_value(options, option_descriptions(), name);
}

class GrammarNLU : public nlu::RenewedNLU<nlu::NluEngine> {
protected:
  std::vector<Value> acts(const nlu::NluEngine& engine, const std::string& text,
                          const Map& context) const override {
    return engine.understand(text, context).acts;
  }

  // All files are read now: an engine that is made later, for new values, must
  // not depend on what is being edited then.
  Expected<void> on_start(const Options& options) override {
    for (const auto& described : option_descriptions())
      if (auto fits = check_option(described, option(options, described.name));
          !fits)
        return fits;
    const auto model = host().understanding();
    auto read = options;
    // Without topics there is nothing that the application's files could mean.
    if (!model)
      for (const auto* file : {"examples", "wordings"})
        read.erase(file);
    auto sources = std::make_shared<const nlu::EngineSources>(
        nlu::read_sources(read, model ? *model : UnderstandingModel(),
                          host().application_folder()));
    return begin([sources = std::move(sources)](const ColumnReader& columns) {
      return nlu::build_engine(*sources, columns);
    });
  }
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

// The text of a list that the platform ships; empty where an application has a
// generic grammar of its own and no platform.
std::string platform_list(const Options& options, const std::string& name,
                          std::vector<Error>& errors) {
  const auto platform = option(options, "platform");
  if (platform.empty())
    return {};
  auto text = read_file(platform + "/" + name);
  if (text)
    return std::move(*text);
  errors.push_back(text.error());
  return {};
}

std::vector<std::string> read_other_talk(std::string_view text) {
  const auto lines = lines_of(text);
  return {lines.begin(), lines.end()};
}

// Reads the file that an option names, if it does, by `read`, which returns
// errors.
void read_own_file(const Options& options,
                   const std::string& application_folder,
                   const std::string& name, std::vector<Error>& errors,
                   const auto& read) {
  const auto file = option(options, name);
  if (file.empty())
    return;
  const auto path = inside(application_folder, file, name);
  if (!path)
    return errors.push_back(path.error());
  for (auto& error : read(*path))
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
  read.synonyms = read_synonyms(platform_list(options, "synonyms.txt", errors));
  read.other_talk =
      read_other_talk(platform_list(options, "other-talk.txt", errors));
  if (const auto platform = option(options, "platform"); !platform.empty())
    read.language = language_store().read(platform, errors);
  if (!errors.empty())
    return tl::make_unexpected(std::move(errors));
  return read;
}

// Everything is read even after an error, so that all errors are reported at
// once.
EngineSources read_sources(const Options& options, UnderstandingModel model,
                           const std::string& application_folder) {
  EngineSources sources;
  if (auto platform = read_platform(options, application_folder))
    sources.platform = std::move(*platform);
  else
    sources.errors = std::move(platform.error());
  read_own_file(
      options, application_folder, "examples", sources.errors,
      [&](const auto& path) { return add_example_file(path, model); });
  read_own_file(options, application_folder, "wordings", sources.errors,
                [&](const auto& path) {
                  return read_wording_file(path, model,
                                           sources.platform.wordings);
                });
  sources.model = std::move(model);
  return sources;
}

tl::expected<NluEngine, std::vector<Error>>
build_engine(const EngineSources& sources, const ColumnReader& columns) {
  auto errors = sources.errors;
  auto built = engine_store().get(sources.model, sources.platform, columns);
  if (!built)
    errors.insert(errors.end(), built.error().begin(), built.error().end());
  if (!errors.empty())
    return tl::make_unexpected(std::move(errors));
  return built;
}

tl::expected<NluEngine, std::vector<Error>>
build_engine(const Options& options, UnderstandingModel model,
             const ColumnReader& columns,
             const std::string& application_folder) {
  return build_engine(
      read_sources(options, std::move(model), application_folder), columns);
}

std::vector<LeftOutExample>
try_examples(const Options& options, UnderstandingModel model,
             const ColumnReader& columns,
             const std::string& application_folder) {
  const auto sources =
      read_sources(options, std::move(model), application_folder);
  if (!sources.errors.empty())
    return {};
  return read_left_out(sources.model, columns, sources.platform);
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
