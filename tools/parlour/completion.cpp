#include "tools/parlour/completion.hpp"

#include <CLI/CLI.hpp>

namespace parlour::tools {

namespace {

std::string options_of(const CLI::App& command) {
  std::string words;
  for (const auto* option : command.get_options())
    for (const auto& name : option->get_lnames())
      words += (words.empty() ? "--" : " --") + name;
  return words;
}

} // namespace

std::string completion_script(const CLI::App& app) {
  std::string commands;
  std::string cases;
  for (const auto* command : app.get_subcommands(nullptr)) {
    if (command->get_group().empty())
      continue; // not shown
    commands += command->get_name() + ' ';
    cases += "    " + command->get_name() + ") words=\"" +
             options_of(*command) + "\" ;;\n";
  }
  return "# parlour: completion for bash; source <(parlour completion bash)\n"
         "_parlour() {\n"
         "  local word=${COMP_WORDS[COMP_CWORD]} words=\n"
         "  if ((COMP_CWORD == 1)); then\n"
         "    COMPREPLY=($(compgen -W \"" +
         commands + options_of(app) +
         "\" -- \"$word\"))\n"
         "    return\n"
         "  fi\n"
         "  case ${COMP_WORDS[1]} in\n" +
         cases +
         "  esac\n"
         "  if [[ $word == -* ]]; then\n"
         "    COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n"
         "  else\n"
         "    COMPREPLY=($(compgen -f -- \"$word\")\n"
         "      $(cd config/apps 2>/dev/null && compgen -d -- \"$word\"))\n"
         "  fi\n"
         "}\n"
         "complete -o filenames -F _parlour parlour\n";
}

} // namespace parlour::tools
