#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <ostream>
#include <thread>

#include "script/xml/source_reader.hpp"
#include "tools/parlour/application/fix.hpp"
#include "tools/parlour/application/opening.hpp"
#include "tools/parlour/cli/commands.hpp"
#include "tools/parlour/console/exit_code.hpp"
#include "tools/parlour/console/finding_text.hpp"
#include "tools/parlour/console/folder_watch.hpp"
#include "tools/parlour/console/signal_watch.hpp"
#include "tools/parlour/conversation_test/conversation_runner.hpp"
#include "tools/parlour/conversation_test/junit.hpp"
#include "tools/parlour/conversation_test/report.hpp"
#include "tools/parlour/conversation_test/test_suite.hpp"
#include "tools/parlour/conversation_test/witness.hpp"

namespace parlour::tools {

namespace {

using Results = std::vector<ConversationResult>;

// Conversations are shared out among threads; each has its own node.
Results hold_all(const Application& application, const TestSuite& suite,
                 const TestOptions& options, Coverage& coverage) {
  Results results(suite.conversations.size());
  std::vector<Coverage> seen(results.size(), coverage);
  const auto words = options.update ? Words::any : Words::as_written;
  Witness witness;
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < results.size(); i = next++) {
      const auto& conversation = suite.conversations[i];
      const Witness::Held held(witness, conversation.file);
      results[i] = hold_conversation(application, conversation, seen[i], words);
    }
  };
  const auto jobs = options.jobs
                        ? options.jobs
                        : std::max(1u, std::thread::hardware_concurrency());
  std::vector<std::jthread> threads;
  for (unsigned i = 1; i < std::min<std::size_t>(jobs, results.size()); ++i)
    threads.emplace_back(work);
  work();
  threads.clear();
  for (const auto& part : seen)
    coverage.add(part);
  return results;
}

bool write_junit(const TestOptions& options, const std::string& name,
                 const Results& results, const Console& console) {
  if (options.junit.empty())
    return true;
  std::ofstream file(options.junit, std::ios::binary);
  print_junit(file, name, results);
  file.close();
  if (!file)
    say_error(console,
              options.junit + " cannot be written: " + std::strerror(errno));
  return !!file;
}

Expected<void> rewrite(const std::filesystem::path& file,
                       const std::vector<Rewording>& rewordings) {
  const auto text = script::read_bytes(file);
  return text ? replace_file(file, reworded(*text, rewordings))
              : Expected<void>(tl::make_unexpected(text.error()));
}

// A conversation that went wrong in more than its words stays as it is.
bool update_files(const TestSuite& suite, const Results& results,
                  const Console& console) {
  bool well = true;
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (results[i].failure || results[i].rewordings.empty())
      continue;
    if (auto written = rewrite(suite.files[i], results[i].rewordings))
      print_rewordings(console.out, results[i]);
    else {
      say_error(console, written.error().message);
      well = false;
    }
  }
  return well;
}

bool all_passed(const Results& results) {
  return std::none_of(results.begin(), results.end(),
                      [](const auto& result) { return !!result.failure; });
}

// Warnings are errors here.
bool refused(const std::vector<script::Finding>& findings, const Places& places,
             const Console& console) {
  if (findings.empty())
    return false;
  print_lines(console.out, findings, places);
  say_error(console, "no conversation is held: " + to_string(count(findings)));
  return true;
}

int hold_and_report(const Application& application, const TestSuite& suite,
                    const Places& places, const TestOptions& options,
                    const Console& console) {
  Coverage coverage(*application.program);
  const auto results = hold_all(application, suite, options, coverage);
  // Before anything is printed, as its reader may go away.
  const auto written = write_junit(options, application.program->settings.name,
                                   results, console);
  print_failures(console.out, results, options.trace);
  const auto updated = update_files(suite, results, console);
  if (!options.quiet)
    print(console.out, coverage, places);
  print_summary(console.out, results);
  return updated && written && all_passed(results) ? exit_code::well
                                                   : exit_code::wrong;
}

int test_once(const Places& places, const TestOptions& options,
              const Console& console) {
  auto opened = open_application(places, options.app, console, Scrutiny::lint);
  if (const auto* status = std::get_if<int>(&opened))
    return *status;
  const auto& application = std::get<Application>(opened);
  const auto suite = read_suite(application, options.files, places);
  if (!suite) {
    say_error(console, to_string(suite.error()));
    return exit_code::usage;
  }
  if (refused(application.findings, places, console) ||
      refused(suite->findings, places, console))
    return exit_code::wrong;
  if (suite->conversations.empty()) {
    say_error(console, options.app + " has no conversations: nothing was "
                                     "tested; write one into dialogues/, a "
                                     "file that ends in .txt");
    return exit_code::wrong;
  }
  return hold_and_report(application, *suite, places, options, console);
}

// Until Ctrl-C. What changes while conversations are held counts as well.
int test_again_and_again(const Places& places, const TestOptions& options,
                         const Console& console) {
  SignalWatch signals;
  const auto folder = find_application(places, options.app);
  if (!folder) {
    say_error(console, folder.error().message);
    return exit_code::usage;
  }
  auto watch = FolderWatch::open();
  if (!watch) {
    say_error(console, watch.error().message);
    return exit_code::wrong;
  }
  watch->add(*folder);
  watch->add(find_platform(places, *folder));
  for (const auto& name : options.files)
    watch->add(places.working / name);
  do {
    test_once(places, options, console);
    if (!console.out.flush())
      return exit_code::well; // who called this tells of it
    console.err << coloured(console, grey, "waiting for changes; Ctrl-C ends\n")
                << std::flush;
  } while (watch->wait(signals.descriptor()));
  return signals.status();
}

} // namespace

int test_command(const Places& places, const TestOptions& options,
                 const Console& console) {
  return options.watch ? test_again_and_again(places, options, console)
                       : test_once(places, options, console);
}

} // namespace parlour::tools
