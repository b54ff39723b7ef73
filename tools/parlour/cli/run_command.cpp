#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <mutex>
#include <ostream>

#include <unistd.h>

#include "adapters/database/sqlite/sqlite_origin.hpp"
#include "tools/parlour/application/data_folder.hpp"
#include "tools/parlour/application/node_options.hpp"
#include "tools/parlour/application/opening.hpp"
#include "tools/parlour/cli/commands.hpp"
#include "tools/parlour/console/descriptor_source.hpp"
#include "tools/parlour/console/exit_code.hpp"
#include "tools/parlour/console/printer.hpp"
#include "tools/parlour/console/signal_watch.hpp"
#include "tools/parlour/talk/terminal_run.hpp"
#include "tools/parlour/talk/text_run.hpp"
#include "tools/parlour/talk/trace.hpp"

namespace parlour::tools {

namespace {

// Lines about the conversation, from any thread.
class Notes {
public:
  Notes(const Console& console, Printer& printer, std::filesystem::path log)
      : console_(console), printer_(printer), log_(std::move(log)) {}
  void show(const std::string& text) {
    printer_.err(coloured(console_, grey, text));
  }
  // Where showing would be in the way.
  void keep(const std::string& text) {
    std::lock_guard lock(mutex_);
    std::ofstream(log_, std::ios::app) << text << std::endl;
  }

private:
  std::mutex mutex_; // of the log
  const Console& console_;
  Printer& printer_;
  std::filesystem::path log_;
};

// Talks no faster than somebody reads.
class PacedPartner : public NodePartner {
public:
  PacedPartner(actors::Node& node, bool is_virtual, Printer& printer)
      : NodePartner(node, is_virtual,
                    [&printer](const std::string& text) { printer.out(text); }),
        printer_(printer) {}
  void enter(const std::vector<std::string>& turns) override {
    printer_.wait_for_room();
    NodePartner::enter(turns);
  }
  void let_time_pass() override {
    printer_.wait_for_room();
    NodePartner::let_time_pass();
  }

private:
  Printer& printer_;
};

// A server's database is not ours to drop.
Expected<void> put_databases_aside(const Application& application,
                                   const std::filesystem::path& data) {
  for (const auto& component : application.composition.components) {
    if (component.factory.description.name != "SQLiteDatabase")
      continue;
    const auto options = adapters::read_sqlite_options(
        component.options, data.string(), application.folder.string());
    if (!options || options->in_memory() || options->schema.empty())
      continue; // wrong options are told when it starts
    if (auto done = adapters::put_aside(options->file); !done)
      return done;
  }
  return {};
}

bool wants_terminal(const RunOptions& options) {
  return !options.text && isatty(STDIN_FILENO) && isatty(STDOUT_FILENO);
}

class Run {
public:
  Run(const Application& application, const RunOptions& options,
      const Console& console, const std::filesystem::path& data,
      SignalWatch& signals)
      : application_(application), options_(options), console_(console),
        data_(data), signals_(signals),
        printer_(console.out, console.err, [this] { signals_.raise_closed(); }),
        notes_(console, printer_, data / "log") {}

  int run() {
    for (const auto& notice : application_.composition.notices)
      say_warning(console_, notice);
    auto node = actors::Node::start(options());
    if (!node) {
      printer_.finish(); // what was noted before
      say_error(console_, to_string(node.error()));
      return exit_code::wrong;
    }
    signals_.on_interrupt([&] {
      (*node)->interrupt();
      printer_.give_up();
    });
    if (wants_terminal(options_))
      talk_on_terminal(**node);
    else
      talk_by_lines(**node);
    finish();
    return ended_;
  }

private:
  actors::NodeOptions options() {
    auto made = node_options(application_, application_.composition,
                             {data_.string(), options_.clock, options_.seed});
    made.inspect_all = options_.trace;
    made.on_inspection = [this](const Inspection& seen) { watch(seen); };
    made.log = [this](const std::string& text) { log(as_one_line(text)); };
    return made;
  }

  // A script's errors are always shown, and what it logs as such.
  void watch(const Inspection& seen) {
    if (seen.kind == InspectionKind::branch)
      return;
    if (options_.trace || is_trouble(seen))
      note(trace_line(seen));
    else
      log(trace_line(seen));
  }

  static bool is_trouble(const Inspection& seen) {
    return seen.kind == InspectionKind::error ||
           (seen.kind == InspectionKind::log &&
            (seen.subject == "error" || seen.subject == "warning"));
  }

  // A conversation on a terminal is not interrupted by it unless asked for.
  void log(const std::string& text) {
    if (screen_ && !options_.trace)
      notes_.keep(text);
    else
      note(text);
  }

  void note(const std::string& text) {
    if (auto* screen = screen_.load())
      screen->note(text);
    else
      notes_.show(text);
  }

  // An interrupt that came later than this would cut short what ends the
  // sessions in order.
  void end(actors::Node& node) {
    signals_.on_interrupt(nullptr);
    ended_ = signals_.status();
    has_stopped_ = node.stop();
  }

  // What was said reaches its reader, unless nobody wants to wait for that.
  // With something that does not return, a process ends without its farewells.
  void finish() {
    signals_.on_interrupt([this] { printer_.give_up(); });
    const bool all_read = printer_.finish();
    signals_.on_interrupt(nullptr);
    if (!all_read || !has_stopped_)
      std::_Exit(status_of_cutting_short());
  }

  int status_of_cutting_short() const {
    const auto asked_for = signals_.status();
    const bool in_order = has_stopped_ && signals_.interrupted();
    return asked_for == exit_code::well && !in_order ? exit_code::wrong
                                                     : asked_for;
  }

  void talk_by_lines(actors::Node& node) {
    PacedPartner partner(node, options_.clock.has_value(), printer_);
    DescriptorSource source(STDIN_FILENO, signals_.descriptor());
    RowReader rows(source, [this](const std::string& text) { note(text); });
    talk_by_rows(partner, rows);
    end(node);
  }

  void talk_on_terminal(actors::Node& node) {
    Screen screen({stdin, stdout, signals_.descriptor()}, data_ / "history",
                  console_.colour, [&node](const std::string& line) {
                    return node.is_private(line);
                  });
    screen_ = &screen;
    NodePartner partner(node, options_.clock.has_value(),
                        [&](const std::string& text) { screen.say(text); });
    tools::talk_on_terminal(partner, screen);
    end(node);
    screen.flush();
    screen_ = nullptr;
  }

  const Application& application_;
  const RunOptions& options_;
  const Console& console_;
  std::filesystem::path data_;
  SignalWatch& signals_;
  Printer printer_;
  Notes notes_;
  std::atomic<Screen*> screen_ = nullptr; // while there is a terminal
  int ended_ = exit_code::well; // by a signal, before the conversation was over
  bool has_stopped_ = true;     // the node, all of it
};

} // namespace

int run_command(const Places& places, const RunOptions& options,
                const Console& console) {
  if (options.voice) {
    say_error(console, "--voice is not available yet: this build talks by "
                       "text");
    return exit_code::usage;
  }
  SignalWatch signals;
  // Until there is a conversation nothing has to be ended in order.
  signals.on_interrupt([&] { std::_Exit(signals.status()); });
  auto opened = open_application(places, options.app, console);
  if (const auto* status = std::get_if<int>(&opened))
    return *status;
  const auto& application = std::get<Application>(opened);
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
  return Run(application, options, console, data->path(), signals).run();
}

} // namespace parlour::tools
