// The commands and their options, declared for CLI11. To add a command: an
// add_x() below, called by the constructor, and a member with its options.
#include "tools/parlour/cli/command_line.hpp"

#include <algorithm>
#include <iostream>
#include <limits>
#include <utility>

#include <CLI/CLI.hpp>

#include "runtime/base/outside/file_bytes.hpp"
#include "script/lint/lints.hpp"
#include "script/source/findings.hpp"
#include "tools/parlour/cli/agent_flags.hpp"
#include "tools/parlour/cli/commands.hpp"
#include "tools/parlour/cli/number_option.hpp"
#include "tools/parlour/cli/plugins/plugin_commands.hpp"
#include "tools/parlour/cli/run_flags.hpp"
#include "tools/parlour/cli/serve_flags.hpp"
#include "tools/parlour/cli/speech_flags.hpp"
#include "tools/parlour/console/completion.hpp"
#include "tools/parlour/console/exit_code.hpp"
#include "tools/parlour/plugin_template/plugin_skeleton.hpp"
#include "tools/parlour/reference/reference.hpp"

namespace parlour::tools {

namespace {

// One parse of the command line. Each add_x() declares a command whose options
// are written to a member; `chosen_` is then the function to call.
class CommandLine {
public:
  CommandLine(const Places& places, const Console& console)
      : places_(places), console_(console) {
    app_.require_subcommand(1);
    app_.set_version_flag("--version", "parlour " PARLOUR_VERSION);
    app_.footer(exit_code::statuses);
    add_run();
    add_serve();
    add_replay();
    add_journal();
    add_watching();
    add_speech();
    add_check();
    add_format();
    add_schema();
    add_test();
    add_exec();
    add_understand();
    add_bench();
    add_agent();
    add_tap();
    add_plugin();
    add_keygen();
    add_completion();
    add_component();
    add_help();
  }

  // Parses the arguments and runs the chosen command. CLI11 throws for --help
  // and --version, too, with an exit code of 0.
  int run(std::vector<std::string> arguments) {
    if (const auto wrong = trouble_with_first(arguments); !wrong.empty()) {
      say_error(console_, wrong + "; see parlour --help");
      return exit_code::usage;
    }
    std::reverse(arguments.begin(), arguments.end()); // as CLI11 wants them
    try {
      app_.parse(std::move(arguments));
      return status_of_printing(console_, chosen_());
    } catch (const CLI::ParseError& error) {
      return status_of_printing(
          console_, app_.exit(error, console_.out, console_.err) == 0
                        ? exit_code::success
                        : exit_code::usage);
    }
  }

private:
  // The names of the commands, with or without hidden ones.
  std::vector<std::string> commands(bool hidden = true) const {
    std::vector<std::string> names;
    for (const auto* command : app_.get_subcommands(nullptr))
      if (hidden || !command->get_group().empty())
        names.push_back(command->get_name());
    return names;
  }
  // Empty if the first word is a command or a global option.
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

  // Adds a command; run() calls `action` if the user chose it.
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

  // The argument APP, with the option --plugins, which changes the search for
  // its plug-ins.
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
          return files ? check_named(folder)
                       : "'" + folder + "': " + files.error().message;
        });
  }

  void add_run() {
    auto* command = add("run", "Talk with an application", [this] {
      return run_command(places_, run_, console_);
    });
    add_app(command, run_.app, app_sentence);
    add_run_flags(*command, run_);
  }

  void add_serve() {
    auto* command =
        add("serve", "Serve an application to many visitors",
            [this] { return serve_command(places_, serve_, console_); });
    add_app(command, serve_.app, app_sentence);
    add_serve_flags(*command, serve_);
    add_load_flags(
        *add("load", "Visit a server as many, and check its answers",
             [this] { return load_command(places_, load_, console_); }),
        load_);
  }

  void add_watching() {
    for (const auto& its : watch_commands)
      its.add_flags(*add(its.name, its.sentence,
                         [&] { return its.run(places_, watch_, console_); }),
                    watch_);
  }

  void add_speech() {
    add_devices_flags(
        *add("devices", "List microphones and speakers, and try them",
             [this] { return devices_command(devices_, console_); }),
        devices_);
    auto* say = add("say", "Speak a text",
                    [this] { return say_command(places_, say_, console_); });
    add_say_flags(*say, say_);
    auto* listen =
        add("listen", "Show what an application hears in sound files",
            [this] { return listen_command(places_, listen_, console_); });
    add_app(listen, listen_.app, app_sentence);
    add_listen_flags(*listen, listen_);
  }

  // The help of `check` lists all lints, from their table.
  void add_check() {
    auto* command =
        add("check", "Say everything that is wrong with an application",
            [this] { return check_command(places_, check_, console_); });
    add_app(command, check_.app, "A folder, a name, or one script file");
    add_check_flags(*command, check_);
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
    add_format_flags(*add("format", "Lay scripts out",
                          [this] {
                            return format_command(places_, format_, std::cin,
                                                  console_);
                          }),
                     format_);
  }

  void add_schema() {
    add("schema", "Print a schema of scripts, for editors", [this] {
      return schema_command(schema_, console_);
    })->add_flag("--xsd", schema_.xsd, "An XML Schema; else RELAX NG");
  }

  void add_test() {
    auto* command =
        add("test", "Hold an application's conversations in virtual time",
            [this] { return test_command(places_, test_, console_); });
    add_app(command, test_.app, app_sentence);
    add_test_flags(*command, test_);
  }

  void add_exec() {
    auto* command = add("exec", "Run the function main of a script", [this] {
      return exec_command(places_, exec_, console_);
    });
    add_exec_flags(*command, exec_);
  }

  void add_understand() {
    auto* command = add(
        "understand", "Show what the understanding makes of a text, and why",
        [this] { return understand_command(places_, understand_, console_); });
    add_app(command, understand_.app, app_sentence);
    add_understand_flags(*command, understand_);
  }

  void add_bench() {
    auto* command =
        add("bench", "Measure beside others who do the same work", [this] {
          return bench_command(app_.get_subcommand("bench")->remaining(),
                               places_, console_);
        });
    command->prefix_command();
    command->footer("parlour bench NAME [OPTION...] is the program "
                    "parlour-bench, which is made on request:\nin a clone of "
                    "Parlour's sources run tools/bench/run NAME.\n\n" +
                    app_.get_footer());
  }

  void add_agent() {
    auto* command = add("agent", "Run a plug-in as a remote agent", [this] {
      return agent_command(places_, agent_, console_);
    });
    add_agent_flags(*command, agent_);
    add_plugins(command);
  }

  void add_replay() {
    auto* command = add("replay", "Repeat conversations of a journal", [this] {
      return replay_command(places_, replay_, console_);
    });
    add_app(command, replay_.app, app_sentence);
    add_replay_flags(*command, replay_);
  }

  void add_journal() { // a group like `plugin`
    auto* group = app_.add_subcommand("journal", "Look into a journal");
    group->require_subcommand(1);
    for (auto& [name, sentence, run] : journal_commands)
      add_journal_flags(
          *add(*group, name, sentence,
               [this, run = run] { return run(places_, journal_, console_); }),
          name, journal_);
  }

  void add_tap() {
    add_tap_flags(*add("tap", "Print the messages of a running application",
                       [this] { return tap_command(tap_, console_); }),
                  tap_);
  }

  // `plugin` is a group: its commands are subcommands.
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
    add_new_plugin_flags(*made, new_plugin_);
    auto* test =
        add(*plugin, "test", "The conformance test of its roles", [this] {
          return plugin_test_command(places_, test_plugin_, console_);
        });
    add_test_plugin_flags(*test, test_plugin_);
    add_plugins(test);
  }

  void add_keygen() {
    add("keygen", "Make a pair of keys for remote agents",
        [this] { return keygen_command(places_, key_file_, console_); })
        ->add_option("FILE", key_file_, "A new file for the secret key")
        ->required()
        ->check(check_named);
  }

  void add_completion() {
    auto* command =
        add("completion", "Print a shell's completion script", [this] {
          console_.out << completion_script(app_,
                                            {{"--role", component_roles()},
                                             {"roles", component_roles()},
                                             {"help", reference_names()}});
          return exit_code::success;
        });
    command->add_option("SHELL", shell_, "bash")
        ->required()
        ->check(CLI::IsMember({"bash"}));
  }

  // Hidden: the program starts this command itself.
  void add_component() {
    auto* command =
        add("component", "Run a component in a process of its own",
            [this] { return component_command(component_, console_); });
    add_component_flags(*command, component_);
  }

  void add_help() {
    auto* command =
        add("help", "Tell of an element, a function, a role or a command",
            [this] { return help(); });
    add_help_flags(*command, help_);
  }
  // Help on the program, on a command, or on a word of the language.
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
    return exit_code::success;
  }

  static constexpr const char* app_sentence =
      "A folder, or a name in ./config/apps or the installed share";

  Places places_; // a copy: --plugins changes it
  const Console& console_;
  CLI::App app_{"A dialogue platform: talk with applications made of scripts",
                "parlour"};
  std::function<int()> chosen_; // set by the command's callback
  RunOptions run_;
  ServeOptions serve_;
  LoadOptions load_;
  WatchOptions watch_;
  DevicesOptions devices_;
  SayOptions say_;
  ListenOptions listen_;
  CheckOptions check_;
  FormatOptions format_;
  SchemaOptions schema_;
  TestOptions test_;
  UnderstandOptions understand_;
  AgentOptions agent_;
  TapOptions tap_;
  ReplayOptions replay_;
  JournalOptions journal_;
  std::string plugin_app_;
  std::string plugin_role_;
  NewPluginOptions new_plugin_;
  TestPluginOptions test_plugin_;
  std::string key_file_;
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
