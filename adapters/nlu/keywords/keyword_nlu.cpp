#include "adapters/nlu/keywords/keyword_nlu.hpp"

#include <memory>
#include <utility>

#include "adapters/nlu/keywords/keyword_matcher.hpp"
#include "adapters/nlu/values/renewed_nlu.hpp"
#include "runtime/base/outside/file_bytes.hpp"
#include "runtime/plugin/folder.hpp"

namespace parlour::adapters {

namespace {

// The text of the rules, and where it stands.
struct RulesFile {
  std::string text;
  std::string path;
};

// The file may not lie outside of the application's folder.
Expected<RulesFile> read_rules_file(const Options& options,
                                    const std::string& application_folder) {
  const auto given = options.find("rules");
  const auto path = inside(
      application_folder, given == options.end() ? "" : given->second, "rules");
  if (!path)
    return tl::make_unexpected(path.error());
  auto text = read_file(*path);
  if (!text)
    return tl::make_unexpected(text.error());
  return RulesFile{std::move(*text), path->string()};
}

// The plug-in.
class KeywordNLU
    : public nlu::RenewedNLU<std::shared_ptr<const nlu::KeywordMatcher>> {
protected:
  using Matcher = std::shared_ptr<const nlu::KeywordMatcher>;

  std::vector<Value> acts(const Matcher& matcher, const std::string& text,
                          const Map& context) const override {
    return matcher->understand(text, context);
  }

  Expected<void> on_start(const Options& options) override {
    auto file = read_rules_file(options, host().application_folder());
    if (!file)
      return tl::make_unexpected(file.error());
    return begin([file = std::move(*file),
                  model = host().understanding()](const ColumnReader& columns) {
      return nlu::read_keyword_rules(file.text, file.path,
                                     model ? *model : UnderstandingModel(),
                                     columns)
          .map([](nlu::KeywordRules rules) {
            return std::make_shared<const nlu::KeywordMatcher>(
                std::move(rules));
          });
    });
  }
};

} // namespace

tl::expected<nlu::KeywordRules, std::vector<Error>> load_keyword_rules(
    const Options& options, const std::string& application_folder,
    const UnderstandingModel& model, const ColumnReader& columns) {
  const auto file = read_rules_file(options, application_folder);
  if (!file)
    return tl::make_unexpected(std::vector<Error>{file.error()});
  return nlu::read_keyword_rules(file->text, file->path, model, columns);
}

PluginFactory keyword_nlu_factory() {
  PluginDescription description;
  description.name = "KeywordNLU";
  description.roles = {"NLU"};
  description.sentence = "understands by keywords and values alone";
  description.options = {{"rules", "",
                          "the file of its rules, in the application's folder",
                          true}};
  description.is_inline = true;
  return {std::move(description),
          [] { return std::make_unique<KeywordNLU>(); }};
}

} // namespace parlour::adapters
