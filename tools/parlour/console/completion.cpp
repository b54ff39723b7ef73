#include "tools/parlour/console/completion.hpp"

#include <CLI/CLI.hpp>

namespace parlour::tools {

namespace {

std::string options_of(const CLI::App& command) {
  std::string words;
  for (const auto* option : command.get_options())
    if (!option->get_group().empty()) // it is shown
      for (const auto& name : option->get_lnames())
        words += (words.empty() ? "--" : " --") + name;
  return words;
}

// Those that are shown.
std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  std::vector<const CLI::App*> commands;
  for (const auto* command : app.get_subcommands(nullptr))
    if (!command->get_group().empty())
      commands.push_back(command);
  return commands;
}

// Commands and options, where a command is to come.
std::string first_words(const CLI::App& app) {
  std::string words;
  for (const auto* command : commands_of(app))
    words += command->get_name() + ' ';
  return words + options_of(app);
}

// Offers these words.
std::string offer(const std::string& words) {
  return "COMPREPLY=($(compgen -W \"" + words + "\" -- \"$word\")); return";
}

std::string a_case(const std::string& pattern, const std::string& action) {
  return "    '" + pattern + "') " + action + " ;;\n";
}

// Of "plugin" the commands below it are looked at as well.
std::string cases_of_groups(const CLI::App& app) {
  std::string cases;
  for (const auto* command : commands_of(app))
    if (!commands_of(*command).empty())
      cases +=
          a_case(command->get_name(),
                 "((COMP_CWORD > 2)) || { " + offer(first_words(*command)) +
                     "; }; command+=\" ${COMP_WORDS[2]}\"");
  return cases;
}

std::string cases_of_options(const CLI::App& app, const std::string& before) {
  std::string cases;
  for (const auto* command : commands_of(app)) {
    const auto name = before + command->get_name();
    cases += a_case(name, "words=\"" + options_of(*command) + '"') +
             cases_of_options(*command, name + ' ');
  }
  return cases;
}

std::string
cases_of_values(const std::map<std::string, std::vector<std::string>>& values) {
  std::string cases;
  for (const auto& [option, all] : values) {
    std::string words;
    for (const auto& value : all)
      words += (words.empty() ? "" : " ") + value;
    cases += a_case(option, offer(words));
  }
  return cases;
}

} // namespace

std::string completion_script(
    const CLI::App& app,
    const std::map<std::string, std::vector<std::string>>& values) {
  return "# parlour: completion for bash; source <(parlour completion bash)\n"
         "_parlour() {\n"
         "  local word=${COMP_WORDS[COMP_CWORD]} words=\n"
         "  if ((COMP_CWORD == 1)); then\n"
         "    " +
         offer(first_words(app)) +
         "\n"
         "  fi\n"
         "  local command=${COMP_WORDS[1]} before=${COMP_WORDS[COMP_CWORD-1]}\n"
         "  case $command in\n" +
         cases_of_groups(app) +
         "  esac\n"
         "  case $command in\n" +
         cases_of_options(app, "") +
         "  esac\n"
         "  case $before in\n" +
         cases_of_values(values) +
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
