// `parlour serve`: starts a node for an application and a text server, and
// waits for a signal.
//
// Threads: one waits for signals (SignalWatch), one serves all connections, and
// the node's own threads.
#include <mutex>
#include <ostream>

#include <fmt/format.h>
#include <unistd.h>

#include "adapters/loop/wait_until_ready.hpp"
#include "tools/parlour/application/data_folder.hpp"
#include "tools/parlour/application/live_application.hpp"
#include "tools/parlour/application/node_options.hpp"
#include "tools/parlour/application/opening.hpp"
#include "tools/parlour/cli/commands.hpp"
#include "tools/parlour/cli/reload.hpp"
#include "tools/parlour/console/exit_code.hpp"
#include "tools/parlour/console/signal_watch.hpp"
#include "tools/parlour/console/terminal_mode.hpp"
#include "tools/parlour/journal/journaled_node.hpp"
#include "tools/parlour/serve/file_limit.hpp"
#include "tools/parlour/serve/node_host.hpp"
#include "tools/parlour/status/node_watch.hpp"
#include "tools/parlour/status/runtime_folder.hpp"
#include "tools/parlour/talk/trace.hpp"

namespace parlour::tools {

namespace {

// Open files that are no visitor's: of the database, of components, of the log.
constexpr std::size_t other_files = 200;
// For the last words of all sessions.
constexpr Milliseconds drain_time{30'000};

class Service {
public:
  Service(const Application& application, const Places& places,
          const ServeOptions& options, const Console& console,
          const std::filesystem::path& data, SignalWatch& signals)
      : application_(application), places_(places), options_(options),
        console_(console), data_(data), signals_(signals),
        watch_({application.name(), application.folder.string(),
                roles_by_component(application.composition)}) {}

  int run() {
    for (const auto& notice : application_.composition.notices)
      say_warning(console_, notice);
    auto journaled = with_journal(node_options(application_),
                                  {options_.journal, options_.strict});
    if (!journaled)
      return give_up(journaled.error());
    for (const auto& notice : journaled->recovered.notices)
      note(notice);
    auto left = std::move(journaled->recovered.sessions);
    if (!left.empty())
      note(fmt::format("{} conversations go on that the run before has left",
                       left.size()));
    auto node = actors::Node::start(std::move(journaled->options));
    if (!node)
      return give_up(node.error());
    left =
        go_on_at_seats(**node, application_.program->settings, std::move(left));
    NodeHost host;
    auto server = web::TextServer::start(
        server_options(visitors_of(left)), host,
        [this](const std::string& what) { note("error: " + what); });
    if (!server)
      return give_up(server.error());
    host.connect(**node, **server, std::move(left));
    if (auto watched = let_watch(**node, **server); !watched)
      return give_up(watched.error());
    begin(**server);
    wait();
    return end(**node, std::move(*server));
  }

private:
  int give_up(const Error& error) {
    say_error(console_, to_string(error));
    return exit_code::wrong;
  }

  // From any thread.
  void note(const std::string& text) {
    const std::lock_guard lock(mutex_);
    console_.err << text << std::endl;
  }

  actors::NodeOptions node_options(const Application& application) {
    const auto composition = options_.rehearsed
                                 ? rehearsed(application.composition)
                                 : application.composition;
    auto made = tools::node_options(application, composition,
                                    {.data_folder = data_.string(),
                                     .virtual_start = {},
                                     .seed = options_.seed});
    made.real_start = options_.clock;
    made.drain_time = drain_time;
    made.inspect_all = false;
    made.on_inspection = [this](const Inspection& seen) {
      watch_.see(seen);
      if (seen.kind == InspectionKind::error ||
          (seen.kind == InspectionKind::log &&
           (seen.subject == "error" || seen.subject == "warning")))
        note(trace_line(seen) + concern_of(seen));
    };
    made.log = [this](const std::string& text) { note(as_one_line(text)); };
    return made;
  }

  web::ServerOptions server_options(std::vector<web::LeftVisitor> left) {
    web::ServerOptions made;
    made.left = std::move(left);
    made.address = options_.address;
    made.port = options_.port;
    made.origins = options_.origins;
    made.book.linger = options_.linger;
    made.book.sessions = room_for_connections(options_.sessions, other_files);
    if (made.book.sessions < options_.sessions)
      say_warning(console_,
                  fmt::format("this system lets a process open only {} files: "
                              "at most {} sessions at a time instead of {} "
                              "(ulimit -Hn)",
                              made.book.sessions + other_files,
                              made.book.sessions, options_.sessions));
    sessions_ = made.book.sessions;
    return made;
  }

  // Where somebody waits for the line, nothing else is there before it.
  void begin(const web::TextServer& server) {
    console_.out << fmt::format("{} is served at {} by lines and WebSocket, to "
                                "{} at a time\n",
                                application_.name(), server.address(),
                                sessions_)
                 << std::flush;
  }

  // Until a signal comes.
  void wait() {
    pollfd signal[] = {{signals_.descriptor(), POLLIN, 0}};
    adapters::wait_until_ready(signal);
  }

  // First nobody else is let in, then all sessions end in order and say so,
  // then the connections are closed.
  int end(actors::Node& node, std::unique_ptr<web::TextServer> server) {
    server->stop_accepting();
    watch_.end(); // nobody may ask a node that stops
    const bool stopped = node.stop();
    const auto counts = server->counts();
    server.reset();
    note(fmt::format("{} visitors, {} turns, {} resumed, {} refused",
                     counts.book.visitors, counts.book.turns,
                     counts.book.resumed, counts.book.refused));
    if (!stopped)
      end_now(exit_code::wrong); // destructors would wait for its threads
    return signals_.status();
  }

  Expected<void> let_watch(actors::Node& node, web::TextServer& server) {
    const auto tell = [this](const std::string& line) { note(line); };
    watch_.connect(
        node,
        [this, &node](const ReloadRequest& request) {
          return reload(live_, node, request);
        },
        [&server] { return metrics_of(server.counts()); });
    return watch_.serve(runtime_folder(places_), options_.metrics, tell, tell);
  }

  const Application& application_;
  const Places& places_;
  const ServeOptions& options_;
  const Console& console_;
  const std::filesystem::path data_;
  SignalWatch& signals_;
  std::mutex mutex_; // of what is noted
  std::size_t sessions_ = 0;
  LiveApplication live_{
      application_,
      [this](const Console& console) {
        return open_application(places_, application_.folder.string(), console);
      },
      [this](const Application& changed) { return node_options(changed); }};
  NodeWatch watch_; // ends before what it calls
};

// With --rehearsed nothing is kept.
Expected<DataFolder> data_folder(const Places& places,
                                 const ServeOptions& options,
                                 const std::filesystem::path& application) {
  if (options.rehearsed && options.data.empty())
    return DataFolder::temporary();
  const Expected<std::filesystem::path> folder =
      options.data.empty() ? default_data_folder(places, application)
                           : places.working / options.data;
  return folder.and_then(DataFolder::open);
}

} // namespace

int serve_command(const Places& places, const ServeOptions& options,
                  const Console& console) {
  SignalWatch signals;
  // Before it serves, a signal may end the process at once.
  signals.on_interrupt([&] { end_now(signals.status()); });
  auto opened = open_application(places, options.app, console);
  if (const auto* status = std::get_if<int>(&opened))
    return *status;
  const auto& application = std::get<Application>(opened);
  const auto data = data_folder(places, options, application.folder);
  if (!data) {
    say_error(console, data.error().message);
    return exit_code::wrong;
  }
  signals.on_interrupt(nullptr);
  return Service(application, places, options, console, data->path(), signals)
      .run();
}

} // namespace parlour::tools
