#include <ostream>

#include <unistd.h>

#include "tools/parlour/commands.hpp"
#include "tools/parlour/data_folder.hpp"
#include "tools/parlour/descriptor_source.hpp"
#include "tools/parlour/exit_code.hpp"
#include "tools/parlour/node_options.hpp"
#include "tools/parlour/opening.hpp"
#include "tools/parlour/robot_voice.hpp"
#include "tools/parlour/signal_watch.hpp"
#include "tools/parlour/terminal_run.hpp"
#include "tools/parlour/text_run.hpp"
#include "tools/parlour/trace.hpp"

namespace parlour::tools {

namespace {

// Lines about the conversation, from any thread.
class Notes {
public:
  explicit Notes(const Console& console) : console_(console) {}
  void add(const std::string& text) {
    std::lock_guard lock(mutex_);
    console_.err << coloured(console_, grey, text) << std::endl;
  }

private:
  std::mutex mutex_;
  const Console& console_;
};

bool wants_terminal(const RunOptions& options) {
  return !options.text && isatty(STDIN_FILENO) && isatty(STDOUT_FILENO);
}

class Run {
public:
  Run(const Application& application, const RunOptions& options,
      const Console& console, const std::filesystem::path& data,
      SignalWatch& signals)
      : application_(application), options_(options), console_(console),
        data_(data), signals_(signals), notes_(console) {}

  int run() {
    for (const auto& notice : application_.composition.notices)
      say_warning(console_, notice);
    auto node = actors::Node::start(options());
    if (!node) {
      say_error(console_, to_string(node.error()));
      return exit_code::wrong;
    }
    signals_.on_interrupt([&] { (*node)->interrupt(); });
    const auto ended =
        wants_terminal(options_) ? on_terminal(**node) : by_lines(**node);
    signals_.on_interrupt(nullptr);
    (*node)->stop();
    return ended || !signals_.interrupted() ? exit_code::well
                                            : exit_code::interrupted;
  }

private:
  actors::NodeOptions options() {
    auto made = node_options(application_, application_.composition,
                             {data_.string(), options_.clock, options_.seed});
    if (options_.trace)
      made.on_inspection = [this](const Inspection& seen) {
        if (seen.kind != InspectionKind::branch)
          note(trace_line(seen));
      };
    made.log = [this](const std::string& text) { note(as_one_line(text)); };
    return made;
  }

  void note(const std::string& text) {
    if (screen_)
      screen_->note(text);
    else
      notes_.add(text);
  }

  bool by_lines(actors::Node& node) {
    RobotVoice voice(console_.out, [this] { signals_.raise_closed(); });
    const auto seat =
        node.open_seat({[&](const SessionId&, const dialogue::Output& output) {
                          voice.say(output.text);
                        },
                        {}});
    node.open(seat);
    DescriptorSource source(STDIN_FILENO, signals_.descriptor());
    RowReader rows(source, [this](const std::string& text) { note(text); });
    NodePartner partner(node, seat, options_.clock.has_value());
    const auto ended = talk_by_rows(partner, rows) && !signals_.interrupted();
    node.stop(); // while there is a voice
    return ended;
  }

  bool on_terminal(actors::Node& node) {
    Screen screen(signals_.descriptor(), data_ / "history", console_.colour);
    screen_ = &screen;
    const auto seat =
        node.open_seat({[&](const SessionId&, const dialogue::Output& output) {
                          screen.say(as_one_line(output.text));
                        },
                        {}});
    node.open(seat);
    NodePartner partner(node, seat, options_.clock.has_value());
    const auto ended =
        talk_on_terminal(partner, screen) && !signals_.interrupted();
    node.stop();
    screen.flush();
    screen_ = nullptr;
    return ended;
  }

  const Application& application_;
  const RunOptions& options_;
  const Console& console_;
  std::filesystem::path data_;
  SignalWatch& signals_;
  Notes notes_;
  Screen* screen_ = nullptr; // while there is a terminal
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
  auto opened = open_application(places, options.app, console);
  if (const auto* status = std::get_if<int>(&opened))
    return *status;
  const auto& application = std::get<Application>(opened);
  const auto folder = options.data.empty()
                          ? default_data_folder(places, application.folder)
                          : places.working / options.data;
  const auto data = DataFolder::open(folder);
  if (!data) {
    say_error(console, data.error().message);
    return exit_code::wrong;
  }
  return Run(application, options, console, data->path(), signals).run();
}

} // namespace parlour::tools
