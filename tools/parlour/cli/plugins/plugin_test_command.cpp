// `parlour plugin test`: runs the conformance test in a child process.
//
// A plug-in may crash, call exit() or hang. So the parent forks a child, which
// loads the plug-in, runs the test and sends its report through a pipe. The
// parent reads until the pipe is closed and then looks how the child ended. A
// shared page tells it which step the child was in.
#include <cerrno>
#include <csignal>
#include <cstring>
#include <ostream>
#include <string_view>

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "runtime/plugin/conformance.hpp"
#include "tools/parlour/application/data_folder.hpp"
#include "tools/parlour/application/plugins/shipped_plugin.hpp"
#include "tools/parlour/cli/plugins/given_plugin.hpp"
#include "tools/parlour/cli/plugins/plugin_commands.hpp"
#include "tools/parlour/console/exit_code.hpp"

namespace parlour::tools {

namespace {

// Time for the whole test; SIGALRM then ends the child.
constexpr unsigned trial_seconds = 60;

// What the child says: its exit status, and the text to print.
struct Report {
  int status = exit_code::success;
  std::string text;
};

// The step that the child is in, in memory that parent and child share. The
// child writes, and the parent reads after the child has ended. If the memory
// cannot be mapped, the step is unknown (empty).
class Progress {
public:
  Progress()
      : memory_(mmap(nullptr, size, PROT_READ | PROT_WRITE,
                     MAP_SHARED | MAP_ANONYMOUS, -1, 0)) {}
  ~Progress() {
    if (memory_ != MAP_FAILED)
      munmap(memory_, size);
  }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void is_at(const std::string& step) {
    if (memory_ != MAP_FAILED)
      std::strncpy(static_cast<char*>(memory_), step.c_str(), size - 1);
  }
  std::string step() const {
    return memory_ == MAP_FAILED ? "" : static_cast<const char*>(memory_);
  }

private:
  static constexpr std::size_t size = 256; // the last byte stays 0
  void* memory_;
};

// The child: loads the plug-in and runs the conformance test.
Report try_out(const Places& places, const TestPluginOptions& asked,
               const std::string& data, Progress& progress) {
  progress.is_at("opening it");
  auto factory = given_plugin(places, asked.plugin);
  if (!factory)
    return {exit_code::usage, "error: " + factory.error().message + "\n"};
  auto options = given_options(asked.options, factory->description);
  if (!options)
    return {exit_code::usage, "error: " + options.error().message + "\n"};
  complete_description(factory->description, *options, places.working);
  const auto wrong = conformance_errors(
      *factory,
      {std::move(*options), Milliseconds(2'000), data, places.working.string(),
       [&](const auto& step) { progress.is_at(step); }, asked.load_time});
  std::string text;
  for (const auto& sentence : wrong)
    text += asked.plugin + ": " + sentence + '\n';
  text +=
      asked.plugin + ": " +
      (wrong.empty() ? "conforms" : std::to_string(wrong.size()) + " wrong") +
      '\n';
  return {wrong.empty() ? exit_code::success : exit_code::wrong,
          std::move(text)};
}

// Writes all bytes, also if the pipe takes them in parts.
void write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const auto size = ::write(descriptor, text.data(), text.size());
    if (size <= 0)
      return;
    text.remove_prefix(static_cast<std::size_t>(size));
  }
}

// Reads until the other end is closed.
std::string read_all(int descriptor) {
  std::string text;
  char buffer[4096];
  while (true) {
    const auto size = ::read(descriptor, buffer, sizeof buffer);
    if (size == 0 || (size < 0 && errno != EINTR))
      return text;
    if (size > 0)
      text.append(buffer, static_cast<std::size_t>(size));
  }
}

// How the child ended, in words; empty if it has sent its report and exited
// normally.
std::string end_of(int status, const std::string& text) {
  if (!WIFSIGNALED(status))
    return text.empty() ? "it ends its process with status " +
                              std::to_string(WEXITSTATUS(status))
                        : "";
  if (WTERMSIG(status) == SIGALRM)
    return "it hangs: the test was ended after " +
           std::to_string(trial_seconds) + " s";
  return std::string("it ends its process: ") + strsignal(WTERMSIG(status));
}

} // namespace

int plugin_test_command(const Places& places, const TestPluginOptions& options,
                        const Console& console) {
  const auto data = DataFolder::temporary();
  Progress progress;
  int ends[2];
  if (!data || pipe(ends) != 0) {
    say_error(console, data ? "no pipe can be made" : data.error().message);
    return exit_code::wrong;
  }
  // The child leaves by _exit, so that neither destructors nor atexit handlers
  // of the parent run twice.
  const auto child = fork();
  if (child == 0) {
    ::close(ends[0]);
    alarm(trial_seconds);
    const auto report =
        try_out(places, options, data->path().string(), progress);
    write_all(ends[1], report.text);
    _exit(report.status);
  }
  // Close our copy of the write end: read_all ends when the child's copy is
  // closed, however the child ends.
  ::close(ends[1]);
  const auto text = read_all(ends[0]);
  ::close(ends[0]);
  int status = 0;
  while (child > 0 && waitpid(child, &status, 0) < 0 && errno == EINTR)
    continue;
  // `why` is set if the child could not report. Its own text then still helps,
  // so both are printed.
  const auto why = child > 0 ? end_of(status, text) : "no process can be made";
  if (!why.empty())
    say_error(console, options.plugin + ": " + progress.step() + ": " + why);
  const auto code = why.empty() ? WEXITSTATUS(status) : exit_code::wrong;
  (code == exit_code::usage ? console.err : console.out) << text << std::flush;
  return code;
}

} // namespace parlour::tools
