// `parlour run`: starts a node for an application and connects it to a terminal
// or to standard input and output (tools/parlour/talk).
//
// Threads: one drives the node and reads the input, one writes (Printer), one
// waits for signals (SignalWatch), and the node's own threads call watch() and
// log(). docs/running.md says how a run ends.
#include <atomic>
#include <cstdio>
#include <ostream>

#include <fmt/format.h>
#include <unistd.h>

#include "tools/parlour/application/agent_listener.hpp"
#include "tools/parlour/application/data_folder.hpp"
#include "tools/parlour/application/live_application.hpp"
#include "tools/parlour/application/node_options.hpp"
#include "tools/parlour/application/seat_check.hpp"
#include "tools/parlour/cli/commands.hpp"
#include "tools/parlour/cli/reload.hpp"
#include "tools/parlour/cli/run/run_preparation.hpp"
#include "tools/parlour/console/descriptor_source.hpp"
#include "tools/parlour/console/exit_code.hpp"
#include "tools/parlour/console/notes.hpp"
#include "tools/parlour/console/printer.hpp"
#include "tools/parlour/console/signal_watch.hpp"
#include "tools/parlour/console/terminal_mode.hpp"
#include "tools/parlour/journal/journaled_node.hpp"
#include "tools/parlour/status/node_watch.hpp"
#include "tools/parlour/status/runtime_folder.hpp"
#include "tools/parlour/talk/hearing.hpp"
#include "tools/parlour/talk/terminal_run.hpp"
#include "tools/parlour/talk/text_run.hpp"
#include "tools/parlour/talk/trace.hpp"
#include "tools/parlour/talk/voice_progress.hpp"

namespace parlour::tools {

namespace {

VoiceProgress::Roles roles_of(const Composition& composition) {
  VoiceProgress::Roles roles;
  for (const auto& component : composition.components)
    if (!component.factory.description.roles.empty())
      roles[component.name] = component.factory.description.roles.front();
  return roles;
}

// One run of an application, from the node's start to the exit status. The
// members that callbacks use (printer_, notes_, screen_) outlive the node.
class Run {
public:
  Run(const Application& application, const Places& places,
      const RunOptions& options, const Console& console,
      const std::filesystem::path& data, SignalWatch& signals)
      : application_(application), places_(places), options_(options),
        console_(console), data_(data), signals_(signals),
        printer_(console.out, console.err, [this] { signals_.raise_closed(); }),
        notes_(console, printer_, data / "log"),
        hearing_(names_of_role(application.composition, "Microphone")),
        voice_(roles_of(application.composition),
               first_of_role(application.composition, "KeywordSpotter")),
        key_(isatty(STDIN_FILENO) ? key_of_terminal(application.composition)
                                  : nullptr),
        watch_({application.name(), application.folder.string(),
                roles_by_component(application.composition)}) {}

  int run() {
    for (const auto& notice : application_.composition.notices)
      say_warning(console_, notice);
    auto agents = listen();
    if (!agents)
      return give_up(agents.error());
    agents_ = std::move(*agents);
    auto tap = open_tap(application_.program->settings.agents, options_.taps);
    if (!tap)
      return give_up(tap.error());
    tap_ = std::move(*tap);
    if (tap_)
      notes_.show("taps connect at " + tap_->address());
    progress(voice_.line());
    auto journaled = with_journal(options(application_),
                                  {options_.journal, options_.strict});
    if (!journaled)
      return give_up(journaled.error());
    for (const auto& notice : journaled->recovered.notices)
      note(notice);
    left_ = std::move(journaled->recovered.sessions);
    auto node = actors::Node::start(std::move(journaled->options));
    if (!node)
      return give_up(node.error());
    // Ctrl-C ends every wait of the node, and nobody waits for the reader any
    // more.
    signals_.on_interrupt([&] {
      (*node)->interrupt();
      printer_.give_up();
      hearing_.end();
    });
    // Where time is virtual, actors run only while somebody talks.
    if (!options_.clock)
      if (auto watched = let_watch(**node); !watched) {
        signals_.on_interrupt(nullptr);
        (*node)->stop();
        return give_up(watched.error());
      }
    go_on_elsewhere(**node);
    if (wants_terminal())
      talk_on_terminal(**node);
    else
      talk_by_lines(**node);
    finish();
    return ended_; // zero, or a signal's status
  }

private:
  int give_up(const Error& error) {
    printer_.finish(); // prints what was noted before
    say_error(console_, to_string(error));
    return exit_code::wrong;
  }

  // Editing and history need a terminal on both sides.
  bool wants_terminal() const {
    return !options_.text && !key_ && isatty(STDIN_FILENO) &&
           isatty(STDOUT_FILENO);
  }

  // Null: no remote agent can connect, and stand-ins take their places. Agents
  // live in real time.
  using Agents = std::shared_ptr<adapters::agents::AgentServer>;
  Expected<Agents> listen() {
    if (options_.simulate || options_.clock)
      return nullptr;
    auto agents = listen_for_agents(
        application_.program->settings.agents, application_.folder,
        options_.agents,
        [this](const std::string& text) { log(as_one_line(text)); });
    if (agents && *agents)
      for (const auto& address : (*agents)->addresses())
        notes_.show("remote agents connect at " + address);
    return agents;
  }

  // Options of the node; its callbacks come from threads of the node.
  actors::NodeOptions options(const Application& application) {
    auto made = node_options(application, application.composition,
                             {.data_folder = data_.string(),
                              .virtual_start = options_.clock,
                              .seed = options_.seed,
                              .agents = agents_});
    made.inspect_all = options_.trace || tap_ || options_.voice;
    made.trace_actors = options_.trace_actors;
    made.on_inspection = [this](const Inspection& seen) { watch(seen); };
    made.log = [this](const std::string& text) { log(as_one_line(text)); };
    return made;
  }

  // Errors and what a script logs as an error or a warning are always shown.
  // The rest is shown with --trace and otherwise left to log().
  void watch(const Inspection& seen) {
    watch_.see(seen);
    if (seen.kind == InspectionKind::message) {
      hearing_.take(*seen.message);
      if (const auto line = voice_.take(*seen.message))
        progress(*line);
      if (tap_)
        tap_->publish(*seen.message);
    }
    if (seen.kind == InspectionKind::branch ||
        !(options_.trace || is_told_always(seen.kind)))
      return;
    if (options_.trace || seen.kind == InspectionKind::actor)
      note(trace_line(seen));
    else if (is_trouble(seen))
      note(trace_line(seen) + concern_of(seen));
    else
      log(trace_line(seen) + concern_of(seen));
  }

  // Only on a terminal, and not between the lines of a trace.
  void progress(const std::string& line) {
    if (!options_.voice || options_.trace || !console_.redraws)
      return;
    if (auto* screen = screen_.load())
      screen->status(line);
    else
      printer_.status(line);
  }

  // The others come only because of --trace or a tap.
  static bool is_told_always(InspectionKind kind) {
    return kind == InspectionKind::error || kind == InspectionKind::log ||
           kind == InspectionKind::unhandled || kind == InspectionKind::actor;
  }

  static bool is_trouble(const Inspection& seen) {
    return seen.kind == InspectionKind::error ||
           (seen.kind == InspectionKind::log &&
            (seen.subject == "error" || seen.subject == "warning"));
  }

  // On a terminal, lines that nobody asked for go to the log file; with pipes
  // they go to standard error.
  void log(const std::string& text) {
    if (screen_ && !options_.trace)
      notes_.keep(text);
    else
      note(text);
  }

  // Above the line that is being typed, if there is a terminal.
  void note(const std::string& text) {
    if (auto* screen = screen_.load())
      screen->note(text);
    else
      notes_.show(text);
  }

  Expected<void> let_watch(actors::Node& node) {
    watch_.connect(node, [this, &node](const ReloadRequest& request) {
      return reload(live_, node, request);
    });
    return watch_.serve(
        runtime_folder(places_), options_.metrics,
        [this](const std::string& line) { log(line); },
        [this](const std::string& line) { note(line); });
  }

  // Stops the node. A first signal has no effect from here on: it would cut
  // short the orderly end of the sessions.
  void end(actors::Node& node) {
    signals_.on_interrupt(nullptr);
    ended_ = signals_.status();
    watch_.end(); // nobody may ask a node that stops
    has_stopped_ = node.stop();
  }

  // Waits until everything is printed, or until a signal says that nobody reads
  // it. If a thread still hangs in a stream, or the node has not stopped, the
  // process ends at once: destructors would wait for that thread for ever.
  void finish() {
    signals_.on_interrupt([this] { printer_.give_up(); });
    const bool all_read = printer_.finish();
    signals_.on_interrupt(nullptr);
    if (!all_read || !has_stopped_)
      end_now(status_of_cutting_short());
  }

  // A cut is a failure unless a signal asked for the end.
  int status_of_cutting_short() const {
    const auto asked_for = signals_.status();
    const bool in_order = has_stopped_ && signals_.interrupted();
    return asked_for == exit_code::success && !in_order ? exit_code::wrong
                                                        : asked_for;
  }

  // At the configured seats where nobody talks by this run; that has the first.
  void go_on_elsewhere(actors::Node& node) {
    const auto& settings = application_.program->settings;
    const auto all = left_.size();
    left_ = go_on_at_seats(node, settings, std::move(left_),
                           settings.seats.empty() ? std::string()
                                                  : settings.seats[0].name);
    if (left_.size() < all)
      note(fmt::format("conversations that go on at other seats: {}",
                       all - left_.size()));
  }

  // The conversation that a run before has left at this seat, if it was killed:
  // the last one goes on.
  std::optional<dialogue::SavedSession> last_left() {
    if (left_.empty())
      return std::nullopt;
    if (left_.size() > 1)
      note(fmt::format("{} more conversations of the journal do not go on: "
                       "they have no seat in this run",
                       left_.size() - 1));
    note("the conversation goes on that the run before has left");
    return std::move(left_.back());
  }

  // Piped input: rows of turns (row_reader.hpp), output by the printer.
  void talk_by_lines(actors::Node& node) {
    if (key_) // said before the robot speaks: then it is the visitor's turn
      note("a key begins your turn and ends it: " +
           option_value(key_->options, key_->factory.description.options,
                        "key") +
           "; Ctrl-C ends the conversation");
    PacedDriver driver(node, options_.clock.has_value(), printer_, last_left());
    if (key_ || (talk_by_rows(driver) && options_.voice))
      hearing_.wait();
    end(node);
  }

  bool talk_by_rows(ConversationDriver& driver) {
    DescriptorSource source(STDIN_FILENO, signals_.descriptor());
    RowReader rows(source, [this](const std::string& text) { note(text); });
    return tools::talk_by_rows(driver, rows);
  }

  // A terminal: the screen shows output above the line that is being typed.
  void talk_on_terminal(actors::Node& node) {
    Screen screen({stdin, stdout, signals_.descriptor()}, data_ / "history",
                  console_.colour, [&node](const std::string& line) {
                    return node.is_private(line);
                  });
    screen_ = &screen;
    printer_.status("");
    NodeDriver driver(
        node, options_.clock.has_value(),
        [&](const std::string& text) { screen.say(text); }, last_left());
    tools::talk_on_terminal(driver, screen);
    // Stop first, then flush: the farewell of an ending session is shown, too.
    end(node);
    screen.flush();
    screen_ = nullptr;
  }

  const Application& application_;
  const Places& places_;
  const RunOptions& options_;
  const Console& console_;
  std::filesystem::path data_;
  SignalWatch& signals_;
  Printer printer_;
  Notes notes_;
  Hearing hearing_;
  VoiceProgress voice_;
  const ChosenComponent* key_; // of the terminal; null: there is none
  std::unique_ptr<adapters::agents::MessageTap> tap_; // null: nobody taps
  std::vector<dialogue::SavedSession> left_; // by a run that was killed
  std::atomic<Screen*> screen_ = nullptr;    // set while a terminal is used
  Agents agents_;                            // null: none can connect
  LiveApplication live_{
      application_,
      [this](const Console& console) {
        return open_for_run(places_, options_, application_.folder.string(),
                            console);
      },
      [this](const Application& changed) { return options(changed); }};
  NodeWatch watch_;                // ends before what it calls
  int ended_ = exit_code::success; // exit status, from a signal
  bool has_stopped_ = true;        // whether node.stop() succeeded
};

} // namespace

int run_command(const Places& places, const RunOptions& options,
                const Console& console) {
  if (options.clock && options.metrics) {
    say_error(console, "--metrics excludes --clock, whose time is virtual");
    return exit_code::usage;
  }
  SignalWatch signals;
  // Before the conversation starts, a signal may end the process at once.
  signals.on_interrupt([&] { end_now(signals.status()); });
  auto opened = open_for_run(places, options, options.app, console);
  if (const auto* status = std::get_if<int>(&opened))
    return *status;
  const auto& application = std::get<Application>(opened);
  if (key_of_terminal(application.composition))
    keep_terminal_mode(STDIN_FILENO);
  const Expected<std::filesystem::path> folder =
      options.data.empty() ? default_data_folder(places, application.folder)
                           : places.working / options.data;
  const auto data = folder.and_then(DataFolder::open);
  if (!data) {
    say_error(console, data.error().message);
    return exit_code::wrong;
  }
  if (options.fresh)
    if (auto ready = put_databases_aside(application, data->path()); !ready) {
      say_error(console, to_string(ready.error()));
      return exit_code::wrong;
    }
  if (options.voice && !can_talk(application, options, data->path(), console))
    return exit_code::wrong;
  return Run(application, places, options, console, data->path(), signals)
      .run();
}

} // namespace parlour::tools
