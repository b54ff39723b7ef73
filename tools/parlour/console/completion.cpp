// Builds one bash function `_parlour` of three `case` statements: commands that
// have commands of their own ("plugin"), the options of each command, and
// values after certain words.
#include "tools/parlour/console/completion.hpp"

#include <CLI/CLI.hpp>

namespace parlour::tools {

namespace {

// "--one --two": the visible long options.
std::string options_of(const CLI::App& command) {
  std::string words;
  for (const auto* option : command.get_options())
    if (!option->get_group().empty()) // it is visible
      for (const auto& name : option->get_lnames())
        words += (words.empty() ? "--" : " --") + name;
  return words;
}

// The visible commands.
std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  std::vector<const CLI::App*> commands;
  for (const auto* command : app.get_subcommands(nullptr))
    if (!command->get_group().empty())
      commands.push_back(command);
  return commands;
}

// What may follow the program's name: commands and global options.
std::string first_words(const CLI::App& app) {
  std::string words;
  for (const auto* command : commands_of(app))
    words += command->get_name() + ' ';
  return words + options_of(app);
}

// bash code that completes $word from these words and returns.
std::string offer(const std::string& words) {
  return "COMPREPLY=($(compgen -W \"" + words + "\" -- \"$word\")); return";
}

// One branch of a `case` statement.
std::string a_case(const std::string& pattern, const std::string& action) {
  return "    '" + pattern + "') " + action + " ;;\n";
}

// For a command with commands of its own, such as "plugin": completes the
// second word, and extends $command by it ("plugin list") for the next `case`.
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

// Sets $words to the options of the command; recursive for "plugin list".
std::string cases_of_options(const CLI::App& app, const std::string& before) {
  std::string cases;
  for (const auto* command : commands_of(app)) {
    const auto name = before + command->get_name();
    cases += a_case(name, "words=\"" + options_of(*command) + '"') +
             cases_of_options(*command, name + ' ');
  }
  return cases;
}

// Completes the value of the option or command before the cursor.
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
