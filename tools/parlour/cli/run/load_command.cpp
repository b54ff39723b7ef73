// `parlour load`: plays conversations as visitors of `parlour serve`.
#include <ostream>

#include <fmt/format.h>

#include "runtime/base/outside/file_bytes.hpp"
#include "runtime/base/text/host_and_port.hpp"
#include "tools/parlour/cli/commands.hpp"
#include "tools/parlour/console/exit_code.hpp"
#include "tools/parlour/console/finding_text.hpp"
#include "tools/parlour/console/signal_watch.hpp"
#include "tools/parlour/load/load_run.hpp"
#include "tools/parlour/serve/file_limit.hpp"

namespace parlour::tools {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t other_files = 50;

// A folder of conversations, or of an application that has one, or the name of
// an application.
Expected<std::vector<fs::path>> files_of(const Places& places,
                                         const LoadOptions& options) {
  auto folder = places.working / options.app;
  if (!is_there(folder))
    if (const auto found = find_application(places, options.app))
      folder = *found;
  if (is_there(folder / "dialogues"))
    folder /= "dialogues";
  std::vector<fs::path> files;
  if (options.conversations.empty())
    return list_files(folder, ".txt");
  for (const auto& name : options.conversations) {
    auto path = folder / name;
    if (!is_there(path))
      path += ".txt";
    if (!is_there(path))
      return fail(ErrorKind::settings, "there is no conversation '" + name +
                                           "' in " + folder.string());
    files.push_back(std::move(path));
  }
  return files;
}

struct Reading {
  std::vector<Conversation> conversations; // that can be played
  std::vector<std::string> left_out;       // why the others cannot
  std::vector<script::Finding> errors;
};

Reading read_all(const std::vector<fs::path>& files, const Places& places) {
  Reading reading;
  for (const auto& file : files) {
    auto parsed = read_conversation(file);
    reading.errors.insert(reading.errors.end(), parsed.errors.begin(),
                          parsed.errors.end());
    auto& conversation = parsed.conversation;
    conversation.file = shown_path(places, conversation.file);
    if (const auto why = why_unplayable(conversation))
      reading.left_out.push_back(conversation.file + ": " + *why);
    else
      reading.conversations.push_back(std::move(conversation));
  }
  return reading;
}

// Those of one start: a server's clock has one, too.
std::vector<Played> chosen(const Reading& reading, const LoadOptions& options,
                           std::vector<std::string>& left_out) {
  const auto start = options.clock.value_or(default_start());
  std::vector<Played> all;
  for (const auto& conversation : reading.conversations)
    if (conversation.start == start)
      all.push_back(played(conversation));
    else
      left_out.push_back(conversation.file + ": it begins at another time");
  return all;
}

void print_memory(const LoadRun& run, const Console& console) {
  if (run.memory_before() == 0 || run.most_visitors() < 2)
    return;
  const auto more = static_cast<double>(run.memory_most()) -
                    static_cast<double>(run.memory_before());
  console.out << fmt::format(
      "the server's memory: {:.1f} MB, at most {:.1f} MB with {} visitors: "
      "{:.1f} "
      "KB for each\n",
      static_cast<double>(run.memory_before()) / 1e6,
      static_cast<double>(run.memory_most()) / 1e6, run.most_visitors(),
      more / 1e3 / static_cast<double>(run.most_visitors()));
}

int play(const LoadOptions& options, const HostAndPort& to,
         const std::vector<Played>& conversations, const Console& console) {
  SignalWatch signals;
  auto clients = web::TextClients::start();
  if (!clients) {
    say_error(console, clients.error().message);
    return exit_code::wrong;
  }
  LoadFigures figures;
  VisitorParts parts(**clients, figures);
  parts.address = to.host;
  parts.port = to.port;
  if (options.by_lines)
    parts.by = web::TextClients::By::lines;
  parts.idle = options.idle;
  const auto draws = console.redraws;
  LoadRun run(parts, conversations,
              {options.visitors, options.rate, options.duration, options.idle},
              [&](const std::string& line) {
                if (draws)
                  console.err << '\r' << line << "\033[K" << std::flush;
              });
  signals.on_interrupt([&] { run.interrupt(); });
  run.run();
  signals.on_interrupt(nullptr);
  if (draws)
    console.err << "\r\033[K";
  for (const auto& line : figures.lines(run.time()))
    console.out << line << '\n';
  print_memory(run, console);
  return signals.interrupted() ? signals.status()
         : figures.all_right() ? exit_code::success
                               : exit_code::wrong;
}

} // namespace

int load_command(const Places& places, const LoadOptions& options,
                 const Console& console) {
  const auto to = read_host_and_port(options.to);
  if (!to) {
    say_error(console, "'" + options.to + "' is no HOST:PORT");
    return exit_code::usage;
  }
  const auto files = files_of(places, options);
  if (!files) {
    say_error(console, files.error().message);
    return exit_code::usage;
  }
  auto reading = read_all(*files, places);
  print_lines(console.err, reading.errors, places);
  if (!reading.errors.empty())
    return exit_code::wrong;
  auto left_out = reading.left_out;
  const auto conversations = chosen(reading, options, left_out);
  std::size_t unchecked = 0;
  for (const auto& one : conversations)
    unchecked += one.unchecked;
  for (const auto& line : left_out)
    console.err << "left out: " << line << '\n';
  console.err << fmt::format("{} conversations are played, {} are left out; {} "
                             "expect lines are not checked\n",
                             conversations.size(), left_out.size(), unchecked);
  if (conversations.empty())
    return exit_code::usage;
  if (room_for_connections(options.visitors, other_files) < options.visitors)
    say_warning(console, "this system lets a process open fewer files than "
                         "there are visitors (ulimit -Hn)");
  return play(options, *to, conversations, console);
}

} // namespace parlour::tools
