#include "adapters/nlu/keywords/keyword_nlu.hpp"

#include <memory>
#include <mutex>
#include <utility>

#include "adapters/nlu/keywords/keyword_matcher.hpp"
#include "adapters/nlu/values/known_columns.hpp"
#include "runtime/base/outside/file_bytes.hpp"
#include "runtime/plugin/folder.hpp"

namespace parlour::adapters {

namespace {

// Joins errors to one with a line for each.
Error joined(const std::vector<Error>& errors) {
  auto all = errors.front();
  for (std::size_t at = 1; at < errors.size(); ++at)
    all.message += '\n' + to_string(errors[at]);
  return all;
}

// The plug-in. Any number of threads may ask it: a matcher does not change, but
// another one takes its place where a column has new values.
class KeywordNLU : public InlinePlugin {
public:
  std::vector<Answer> answers(const Message& message) const override {
    if (message.command == "SetValues") {
      set_values(message);
      return {};
    }
    if (message.command != "DoNLU")
      return {{"Failed",
               {"KeywordNLU does not know the command '" + message.command +
                "'."}}};
    const auto text =
        message.params.empty() ? std::string() : message.params[0].text();
    auto acts = matcher()->understand(text, context_of(message));
    if (acts.empty())
      return {{"NoResult", {text}}};
    return {{"FrameInfo", std::move(acts)}};
  }

protected:
  Expected<void> on_start(const Options& options) override {
    options_ = options;
    auto made = make();
    if (!made)
      return tl::make_unexpected(made.error());
    matcher_ = std::move(*made);
    return {};
  }

private:
  using Matcher = std::shared_ptr<const nlu::KeywordMatcher>;

  Expected<Matcher> make() const {
    const auto model = host().understanding();
    auto rules = load_keyword_rules(
        options_, host().application_folder(),
        model ? *model : UnderstandingModel(), [this](const std::string& name) {
          return columns_.read(name, [this](const std::string& column) {
            return host().column(column);
          });
        });
    if (!rules)
      return tl::make_unexpected(joined(rules.error()));
    return std::make_shared<const nlu::KeywordMatcher>(std::move(*rules));
  }

  void set_values(const Message& message) const {
    const auto* values =
        message.params.size() > 1 ? message.params[1].if_list() : nullptr;
    const std::lock_guard one_after_the_other(changing_);
    if (!values || !columns_.set(message.params[0].text(), *values))
      return;
    auto made = make();
    if (!made)
      return host().log("New values are not used: " + made.error().message);
    const std::lock_guard lock(mutex_);
    matcher_ = std::move(*made);
  }

  Matcher matcher() const {
    const std::lock_guard lock(mutex_);
    return matcher_;
  }

  // If the context does not give the present time, the platform's clock does.
  Value context_of(const Message& message) const {
    Map context;
    if (message.params.size() > 1 && message.params[1].if_map())
      context = *message.params[1].if_map();
    if (!context.find("now"))
      context.set("now", host().clock().now());
    return context;
  }

  Options options_;
  // New values may come in the turns of several sessions.
  mutable std::mutex changing_; // guards the columns
  mutable nlu::KnownColumns columns_;
  mutable std::mutex mutex_;
  mutable Matcher matcher_;
};

} // namespace

tl::expected<nlu::KeywordRules, std::vector<Error>> load_keyword_rules(
    const Options& options, const std::string& application_folder,
    const UnderstandingModel& model, const ColumnReader& columns) {
  using Errors = std::vector<Error>;
  const auto given = options.find("rules");
  // The file may not lie outside of the application's folder.
  const auto path = inside(
      application_folder, given == options.end() ? "" : given->second, "rules");
  if (!path)
    return tl::make_unexpected(Errors{path.error()});
  const auto text = read_file(*path);
  if (!text)
    return tl::make_unexpected(Errors{text.error()});
  return nlu::read_keyword_rules(*text, path->string(), model, columns);
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
