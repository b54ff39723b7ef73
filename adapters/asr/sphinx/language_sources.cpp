#include "adapters/asr/sphinx/language_sources.hpp"

#include <utility>

#include "runtime/base/outside/file_bytes.hpp"
#include "runtime/plugin/folder.hpp"

namespace parlour::adapters::asr {

namespace {

// A grammar of the platform; nothing if there is none.
std::optional<GrammarModel> platform_grammar(const std::string& folder,
                                             const char* name) {
  if (folder.empty())
    return {};
  const auto path = folder + "/" + name;
  auto text = read_file(path);
  if (!text)
    return {};
  return GrammarModel{name, std::move(*text), {path, 1, 1}};
}

} // namespace

const std::vector<OptionDescription>& language_options() {
  static const std::vector<OptionDescription> descriptions{
      {"conversations", "dialogues",
       "folder of the application with conversations; what users say there is "
       "expected"},
      {"wordings", "wordings.tsv",
       "file of the application with wordings of its topics, which the domain "
       "model learns"},
      {"platform", "", "folder of what the platform ships"}};
  return descriptions;
}

// A folder of conversations that is not there is empty, and so is a file of
// wordings: applications need none. What is wrong in the file is told by the
// understanding.
Expected<LanguageSources> language_sources(const PluginHost& host,
                                           const Options& options) {
  auto value = [&](const char* name) {
    return option_value(options, language_options(), name);
  };
  LanguageSources sources;
  if (const auto model = host.understanding())
    sources.model = *model;
  sources.columns = [&host](const std::string& name) {
    return host.column(name);
  };
  sources.generic = platform_grammar(value("platform"), "generic-acts.jsgf");
  sources.forms = platform_grammar(value("platform"), "spoken-forms.jsgf");
  if (host.application_folder().empty())
    return sources;
  const auto folder = inside(host.application_folder(), value("conversations"),
                             "conversations");
  if (!folder)
    return tl::make_unexpected(folder.error());
  sources.conversations = read_conversations(*folder);
  const auto wordings =
      inside(host.application_folder(), value("wordings"), "wordings");
  if (!wordings)
    return tl::make_unexpected(wordings.error());
  nlu::read_wording_file(*wordings, sources.model, sources.wordings);
  return sources;
}

} // namespace parlour::adapters::asr
