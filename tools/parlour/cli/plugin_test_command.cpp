#include <cerrno>
#include <csignal>
#include <cstring>
#include <ostream>
#include <string_view>

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "adapters/plugins/plugin_file.hpp"
#include "runtime/plugin/conformance.hpp"
#include "tools/parlour/application/catalogue.hpp"
#include "tools/parlour/application/data_folder.hpp"
#include "tools/parlour/application/option_check.hpp"
#include "tools/parlour/cli/plugin_commands.hpp"
#include "tools/parlour/console/exit_code.hpp"

namespace parlour::tools {

namespace {

// A whole trial; what takes longer hangs.
constexpr unsigned trial_seconds = 60;

Expected<PluginFactory> find(const Places& places, const std::string& plugin) {
  const auto path = places.working / plugin;
  if (path.extension() == ".so")
    return adapters::open_plugin_file(path);
  return Catalogue(plugin_folders(places, places.working)).find(plugin);
}

Expected<Options> read_options(const std::vector<std::string>& given,
                               const PluginDescription& plugin) {
  Options options;
  for (const auto& text : given) {
    const auto equals = text.find('=');
    if (equals == std::string::npos)
      return fail(ErrorKind::settings,
                  "--option " + text + " lacks its '=value'");
    options[text.substr(0, equals)] = text.substr(equals + 1);
  }
  const auto mistakes = option_mistakes(plugin.name, plugin, options);
  if (!mistakes.empty())
    return fail(ErrorKind::settings, mistakes.front().text);
  return options;
}

struct Report {
  int status = exit_code::well;
  std::string text;
};

// What the process on trial does now, seen by the one that waits for it.
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
  static constexpr std::size_t size = 256; // its last byte stays 0
  void* memory_;
};

Report try_out(const Places& places, const TestPluginOptions& asked,
               const std::string& data, Progress& progress) {
  progress.is_at("opening it");
  const auto factory = find(places, asked.plugin);
  if (!factory)
    return {exit_code::usage, "error: " + factory.error().message + "\n"};
  auto options = read_options(asked.options, factory->description);
  if (!options)
    return {exit_code::usage, "error: " + options.error().message + "\n"};
  const auto wrong = nonconformities(
      *factory,
      {std::move(*options), Milliseconds(2'000), data, places.working.string(),
       [&](const auto& step) { progress.is_at(step); }});
  std::string text;
  for (const auto& sentence : wrong)
    text += asked.plugin + ": " + sentence + '\n';
  text +=
      asked.plugin + ": " +
      (wrong.empty() ? "conforms" : std::to_string(wrong.size()) + " wrong") +
      '\n';
  return {wrong.empty() ? exit_code::well : exit_code::wrong, std::move(text)};
}

void write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const auto size = write(descriptor, text.data(), text.size());
    if (size <= 0)
      return;
    text.remove_prefix(static_cast<std::size_t>(size));
  }
}

std::string read_all(int descriptor) {
  std::string text;
  char buffer[4096];
  while (true) {
    const auto size = read(descriptor, buffer, sizeof buffer);
    if (size == 0 || (size < 0 && errno != EINTR))
      return text;
    if (size > 0)
      text.append(buffer, static_cast<std::size_t>(size));
  }
}

// What became of the process, in words; empty where it has said how the trial
// went.
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
  const auto child = fork();
  if (child == 0) {
    close(ends[0]);
    alarm(trial_seconds);
    const auto report =
        try_out(places, options, data->path().string(), progress);
    write_all(ends[1], report.text);
    _exit(report.status);
  }
  close(ends[1]);
  const auto text = read_all(ends[0]);
  close(ends[0]);
  int status = 0;
  while (child > 0 && waitpid(child, &status, 0) < 0 && errno == EINTR)
    continue;
  const auto why = child > 0 ? end_of(status, text) : "no process can be made";
  if (!why.empty())
    say_error(console, options.plugin + ": " + progress.step() + ": " + why);
  const auto code = why.empty() ? WEXITSTATUS(status) : exit_code::wrong;
  (code == exit_code::usage ? console.err : console.out) << text << std::flush;
  return code;
}

} // namespace parlour::tools
