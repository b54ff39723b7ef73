#include "tools/parlour/cli/command_line.hpp"

#include <algorithm>
#include <iostream>
#include <limits>
#include <utility>

#include <CLI/CLI.hpp>

#include "runtime/base/file_bytes.hpp"
#include "script/lint/lints.hpp"
#include "script/source/findings.hpp"
#include "tools/bench/benches.hpp"
#include "tools/bench/nlu/nlu_bench.hpp"
#include "tools/parlour/cli/commands.hpp"
#include "tools/parlour/cli/number_option.hpp"
#include "tools/parlour/cli/plugin_commands.hpp"
#include "tools/parlour/console/completion.hpp"
#include "tools/parlour/console/exit_code.hpp"
#include "tools/parlour/plugin_template/plugin_skeleton.hpp"
#include "tools/parlour/reference/pages.hpp"
#include "tools/parlour/reference/reference.hpp"

namespace parlour::tools {

namespace {

class CommandLine {
public:
  CommandLine(const Places& places, const Console& console)
      : places_(places), console_(console) {
    app_.require_subcommand(1);
    app_.set_version_flag("--version", "parlour " PARLOUR_VERSION);
    app_.footer(exit_statuses);
    add_run();
    add_check();
    add_format();
    add_schema();
    add_test();
    add_exec();
    add_understand();
    add_bench();
    add_plugin();
    add_completion();
    add_component();
    add_help();
  }

  int run(std::vector<std::string> arguments) {
    if (const auto wrong = trouble_with_first(arguments); !wrong.empty()) {
      say_error(console_, wrong + "; see parlour --help");
      return exit_code::usage;
    }
    std::reverse(arguments.begin(), arguments.end());
    try {
      app_.parse(std::move(arguments));
      return status_of_printing(console_, chosen_());
    } catch (const CLI::ParseError& error) {
      return status_of_printing(
          console_, app_.exit(error, console_.out, console_.err) == 0
                        ? exit_code::well
                        : exit_code::usage);
    }
  }

private:
  std::vector<std::string> commands(bool hidden = true) const {
    std::vector<std::string> names;
    for (const auto* command : app_.get_subcommands(nullptr))
      if (hidden || !command->get_group().empty())
        names.push_back(command->get_name());
    return names;
  }
  // Empty where the first word is a command or an option of the program.
  std::string
  trouble_with_first(const std::vector<std::string>& arguments) const {
    if (arguments.empty())
      return "a command is missing";
    const auto& word = arguments.front();
    const bool is_option = word.starts_with('-');
    const auto known =
        is_option ? std::vector<std::string>{"-h", "--help", "--version"}
                  : commands();
    if (std::find(known.begin(), known.end(), word) != known.end())
      return "";
    return std::string("there is no ") + (is_option ? "option" : "command") +
           " '" + word + "'" + script::did_you_mean(word, known);
  }

  // A command that runs `action` when it is chosen.
  template <class Action>
  CLI::App* add(const char* name, const char* sentence, Action action) {
    return add(app_, name, sentence, action);
  }
  template <class Action>
  CLI::App* add(CLI::App& parent, const char* name, const char* sentence,
                Action action) {
    auto* command = parent.add_subcommand(name, sentence);
    command->callback([this, action] { chosen_ = action; });
    return command;
  }

  void add_app(CLI::App* command, std::string& app, const char* sentence) {
    command->add_option("APP", app, sentence)->required();
    add_plugins(command);
  }
  void add_plugins(CLI::App* command) {
    command
        ->add_option("--plugins", places_.plugins,
                     "Folder of plug-ins that are files; else "
                     "$PARLOUR_PLUGINS, or APP/plugins and the installed")
        ->check([this](const std::string& folder) {
          if (!is_there(places_.working / folder))
            return "there is no folder '" + folder + "'";
          const auto files = list_files(places_.working / folder, ".so");
          return files ? is_named(folder)
                       : "'" + folder + "': " + files.error().message;
        });
  }

  // Such as what a variable of a shell holds that is not set.
  static std::string is_named(const std::string& text) {
    return text.empty() ? "an empty name" : "";
  }

  void add_clock(CLI::App* command, std::optional<Timestamp>& clock,
                 const char* sentence) {
    command
        ->add_option_function<std::string>(
            "--clock",
            [&clock](const std::string& text) {
              const auto time = parse_timestamp(text);
              if (!time)
                throw CLI::ValidationError(
                    "--clock", "'" + text +
                                   "' is no time such as \"2026-11-21 "
                                   "09:00\"");
              clock = *time;
            },
            sentence)
        ->type_name("TIME");
  }

  void add_run() {
    auto* command = add("run", "Talk with an application", [this] {
      return run_command(places_, run_, console_);
    });
    add_app(command, run_.app, app_sentence);
    command->add_flag("--text", run_.text,
                      "A turn a line, bare, also on a terminal");
    add_clock(command, run_.clock,
              "Virtual time from here; an empty line steps it to the next due "
              "timer");
    command
        ->add_option("--data", run_.data,
                     "Folder of the run's database, files and records")
        ->check(is_named);
    command->add_flag("--fresh", run_.fresh,
                      "Make the database anew from schema and seed; the old "
                      "file is kept as FILE.before");
    command->add_flag("--trace", run_.trace,
                      "Show every message, transition and slot on stderr");
    add_number<std::uint64_t>(
        command, "--seed", {0, std::numeric_limits<std::uint64_t>::max()},
        "Of all that is random", [this](auto seed) { run_.seed = seed; });
    command->add_flag("--voice", run_.voice,
                      "Microphone and speaker (not available yet)");
  }

  void add_check() {
    auto* command =
        add("check", "Say everything that is wrong with an application",
            [this] { return check_command(places_, check_, console_); });
    add_app(command, check_.app, "A folder, a name, or one script file");
    command->add_flag("--json", check_.json,
                      "Findings as a JSON array of {file, line, column, end, "
                      "kind, name, message, fix}");
    command->add_flag("--fix", check_.fix,
                      "Correct in the files what can safely be corrected");
    std::string lints = "Warned of, besides errors (a comment <!-- check: "
                        "allow NAME --> takes one out):\n";
    for (const auto& lint : script::lint::lints())
      lints +=
          "  " + lint.name +
          std::string(22 - std::min<std::size_t>(lint.name.size(), 21), ' ') +
          lint.sentence + "\n";
    command->footer(lints + "\n" + app_.get_footer());
  }

  void add_format() {
    auto* command = add("format", "Lay scripts out", [this] {
      return format_command(places_, format_, std::cin, console_);
    });
    command
        ->add_option("FILE", format_.files,
                     "Scripts, laid out where they are; - reads standard "
                     "input and writes standard output")
        ->required();
    command->add_flag("--check", format_.check,
                      "Change nothing; status 1 where a file is not laid out");
  }

  void add_schema() {
    auto* command = add("schema", "Print a schema of scripts, for editors",
                        [this] { return schema_command(schema_, console_); });
    command->add_flag("--xsd", schema_.xsd,
                      "An XML Schema; otherwise it is RELAX NG");
  }

  void add_test() {
    auto* command =
        add("test", "Hold an application's conversations in virtual time",
            [this] { return test_command(places_, test_, console_); });
    add_app(command, test_.app, app_sentence);
    command->add_option("FILE", test_.files,
                        "Conversations; all of dialogues/ if there is none");
    command->add_option("--junit", test_.junit, "Results as JUnit's XML")
        ->check(is_named)
        ->type_name("FILE");
    command->add_flag("--trace", test_.trace,
                      "Show what happened in those that failed");
    command->add_flag("--quiet,-q", test_.quiet, "Leave out the coverage");
    command->add_flag("--update", test_.update,
                      "Write what the robot says now into the conversations");
    command
        ->add_flag("--watch", test_.watch,
                   "Hold them again whenever a file changes")
        ->excludes("--junit");
    add_number<unsigned>(command, "--jobs,-j", {1, 1000},
                         "Conversations at a time; else as many as cores",
                         [this](auto jobs) { test_.jobs = jobs; });
  }

  void add_exec() {
    auto* command = add("exec", "Run the function main of a script", [this] {
      return exec_command(places_, exec_, console_);
    });
    command->add_option("FILE", exec_.file, "A script, or an application")
        ->required();
    command->add_flag("--listing", exec_.listing, "Show its compiled code");
  }

  void add_understand() {
    auto* command = add(
        "understand", "Show what the understanding makes of a text, and why",
        [this] { return understand_command(places_, understand_, console_); });
    add_app(command, understand_.app, app_sentence);
    command->add_option("TEXT", understand_.text, "What somebody says")
        ->required();
    add_clock(command, understand_.clock,
              "The time that \"tomorrow\" counts from");
  }

  void add_bench() {
    auto* command =
        add("bench", "Measure beside others who do the same work", [this] {
          return bench_.name == "nlu"
                     ? bench_nlu_command(places_, bench_, console_)
                     : bench_command(bench_, console_);
        });
    std::vector<std::string> names{"nlu"};
    auto rows = nlu_bench_rows();
    for (const auto& bench : benches()) {
      names.push_back(bench.name);
      rows.insert(rows.end(), bench.rows.begin(), bench.rows.end());
    }
    command->add_option("NAME", bench_.name, "What is measured")
        ->required()
        ->check(CLI::IsMember(names));
    add_number<int>(command, "--runs", {1, 1000},
                    "Of each; the median counts; else 5",
                    [this](auto runs) { bench_.runs = runs; });
    command->add_option("--only", bench_.only, "One row of the table")
        ->check(CLI::IsMember(rows));
    command->add_option("--data", bench_.data,
                        "Where the public data sets of nlu are");
    command->add_flag("--validation", bench_.validation,
                      "Of them what is held out of training, not the test");
  }

  void add_plugin() {
    auto* plugin =
        app_.add_subcommand("plugin", "Plug-ins: list, roles, new, test");
    plugin->require_subcommand(1);
    auto* list =
        add(*plugin, "list", "What there is: roles, options, files", [this] {
          return plugin_list_command(places_, plugin_app_, console_);
        });
    list->add_option("APP", plugin_app_, "Also those of an application");
    add_plugins(list);
    add(*plugin, "roles", "What a role's components understand and fire",
        [this] { return plugin_roles_command(plugin_role_, console_); })
        ->add_option("ROLE", plugin_role_, "Such as TTS; else all, in brief");
    auto* made =
        add(*plugin, "new", "Write a new one that builds and passes", [this] {
          return plugin_new_command(places_, new_plugin_, console_);
        });
    made->add_option("NAME", new_plugin_.name, "Such as EchoTTS")->required();
    made->add_option("--role", new_plugin_.role, "Such as TTS")->required();
    made->add_option("--folder", new_plugin_.folder, "Where; else ./NAME")
        ->check(is_named);
    auto* test =
        add(*plugin, "test", "The conformance test of its roles", [this] {
          return plugin_test_command(places_, test_plugin_, console_);
        });
    test->add_option("PLUGIN", test_plugin_.plugin, "FILE.so, or a name")
        ->required();
    test->add_option("--option", test_plugin_.options,
                     "NAME=VALUE, as often "
                     "as there are some");
    add_plugins(test);
  }

  void add_completion() {
    auto* command =
        add("completion", "Print a shell's completion script", [this] {
          console_.out << completion_script(app_,
                                            {{"--role", component_roles()},
                                             {"roles", component_roles()},
                                             {"help", reference_names()}});
          return exit_code::well;
        });
    command->add_option("SHELL", shell_, "bash")
        ->required()
        ->check(CLI::IsMember({"bash"}));
  }

  void add_component() {
    auto* command =
        add("component", "Run a component in a process of its own",
            [this] { return component_command(component_, console_); });
    command->group(""); // not shown
    command->add_option("PLUGIN", component_.plugin, "Its plug-in")->required();
    command->add_option("--plugins", component_.folder, "Its file's folder");
  }

  void add_help() {
    auto* command =
        add("help", "Tell of an element, a function, a role or a command",
            [this] { return help(); });
    command->add_option("NAME", help_.name,
                        "Such as speak, format, TTS; an attribute, an event, "
                        "or a word to look for");
    command->add_option("--page", help_.page, "A page of the reference")
        ->check(CLI::IsMember(reference_pages()))
        ->group(""); // not shown
  }
  // Without a name of the program; with a command's name of that.
  int help() {
    const auto names = commands(false);
    const bool is_command = std::ranges::count(names, help_.name) > 0;
    if (is_command && entries_of(help_.name).empty())
      console_.out << app_.get_subcommand(help_.name)->help(app_.get_name());
    else if (!help_.page.empty() || !help_.name.empty())
      return help_command(help_, names, console_);
    else
      console_.out << app_.get_formatter()->make_help(
          &app_, app_.get_name(), CLI::AppFormatMode::Normal);
    return exit_code::well;
  }

  static constexpr const char* exit_statuses =
      "Exit status: 0 well, also where SIGTERM or SIGHUP has ended a run in "
      "order; 1\nsomething is wrong inside an application or file, or what is "
      "printed cannot be\nwritten; 2 wrong usage, or there is no such "
      "application or file; 130 after Ctrl-C;\n141 nobody reads what is "
      "printed.";
  static constexpr const char* app_sentence =
      "A folder, or a name in ./config/apps or the installed share";

  Places places_;
  const Console& console_;
  CLI::App app_{"A dialogue platform: talk with applications made of scripts",
                "parlour"};
  std::function<int()> chosen_;
  RunOptions run_;
  CheckOptions check_;
  FormatOptions format_;
  SchemaOptions schema_;
  TestOptions test_;
  UnderstandOptions understand_;
  BenchOptions bench_;
  std::string plugin_app_;
  std::string plugin_role_;
  NewPluginOptions new_plugin_;
  TestPluginOptions test_plugin_;
  ExecOptions exec_;
  std::string shell_;
  ComponentOptions component_;
  HelpOptions help_;
};

} // namespace

int run_command_line(std::vector<std::string> arguments, const Places& places,
                     const Console& console) {
  return CommandLine(places, console).run(std::move(arguments));
}

} // namespace parlour::tools
