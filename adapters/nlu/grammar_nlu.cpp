#include "adapters/nlu/grammar_nlu.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>

#include "adapters/nlu/understander.hpp"
#include "runtime/plugin/adaptors.hpp"
#include "runtime/plugin/folder.hpp"

namespace parlour::adapters {

namespace {

std::string option(const Options& options, const std::string& name,
                   std::string fallback) {
  const auto found = options.find(name);
  return found == options.end() || found->second.empty() ? fallback
                                                         : found->second;
}

bool is_of_data(const Error& error) {
  return error.kind == ErrorKind::database || error.kind == ErrorKind::file;
}

// All of them in one: the first one's place, a line for each. Where the data
// cannot be read, the first says why for all.
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
  // A context without a clock gets the platform's.
  std::vector<Value> understand(const std::string& text,
                                const Map& given) const override {
    auto context = given;
    if (!context.find("now"))
      context.set("now", host().clock().now());
    return understander_->understand(text, std::move(context)).acts;
  }

  Expected<void> on_start(const Options& options) override {
    nlu::Understander::Options wanted;
    const auto threshold = parse_number(option(options, "threshold", "0.4"));
    wanted.threshold = threshold.number_or(-1);
    if (wanted.threshold < 0 || wanted.threshold > 1)
      return fail(ErrorKind::settings,
                  "GrammarNLU: threshold is a number from 0 to 1");
    auto generic = nlu::read_generic(options, host().application_folder());
    if (!generic)
      return tl::make_unexpected(generic.error());
    wanted.generic = {std::move(*generic)};
    return build(std::move(wanted));
  }

private:
  Expected<void> build(nlu::Understander::Options wanted) {
    const auto model = host().understanding();
    auto built = nlu::Understander::build(
        model ? *model : UnderstandingModel(),
        [this](const std::string& name) { return host().column(name); },
        std::move(wanted));
    if (!built)
      return tl::make_unexpected(joined(built.error()));
    understander_ = std::make_unique<nlu::Understander>(std::move(*built));
    return {};
  }

  std::unique_ptr<nlu::Understander> understander_;
};

} // namespace

namespace nlu {

Expected<GrammarModel> read_grammar(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file)
    return fail(ErrorKind::file, "cannot read the grammar", {path, 0, 0});
  const auto slash = path.find_last_of('/');
  auto name = slash == std::string::npos ? path : path.substr(slash + 1);
  return GrammarModel{
      name.substr(0, name.find('.')), std::move(text), {path, 1, 1}};
}

Expected<GrammarModel> read_generic(const Options& options,
                                    const std::string& application_folder) {
  const auto own = option(options, "generic", "");
  const auto platform = option(options, "platform", "");
  if (!own.empty())
    return inside(application_folder, own, "generic")
        .and_then([](const auto& path) { return read_grammar(path.string()); });
  if (platform.empty())
    return fail(ErrorKind::settings, "GrammarNLU: neither the option "
                                     "'platform' nor 'generic' is set");
  return read_grammar(platform + "/generic-acts.jsgf");
}

} // namespace nlu

PluginFactory grammar_nlu_factory() {
  PluginDescription description;
  description.name = "GrammarNLU";
  description.roles = {"NLU"};
  description.sentence = "Understands by grammars, examples, names and values.";
  description.options = {
      {"threshold", "0.4", "acts with a lower score are not understood", false},
      {"platform", "", "folder of what the platform ships", false},
      {"generic", "",
       "the application's grammar of generic acts, instead of the platform's",
       false}};
  description.is_inline = true;
  return {std::move(description),
          [] { return std::make_unique<GrammarNLU>(); }};
}

} // namespace parlour::adapters
