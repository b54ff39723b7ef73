// `parlour test`: checks the application, runs its conversations
// (conversation_test/) and prints failures, coverage and a summary.
#include <cerrno>
#include <cstring>
#include <fstream>
#include <optional>
#include <ostream>

#include "script/xml/source_reader.hpp"
#include "tools/parlour/application/fix.hpp"
#include "tools/parlour/application/opening.hpp"
#include "tools/parlour/cli/commands.hpp"
#include "tools/parlour/console/exit_code.hpp"
#include "tools/parlour/console/finding_text.hpp"
#include "tools/parlour/console/folder_watch.hpp"
#include "tools/parlour/console/in_parallel.hpp"
#include "tools/parlour/console/signal_watch.hpp"
#include "tools/parlour/conversation_test/conversation_runner.hpp"
#include "tools/parlour/conversation_test/junit.hpp"
#include "tools/parlour/conversation_test/report.hpp"
#include "tools/parlour/conversation_test/test_suite.hpp"
#include "tools/parlour/conversation_test/witness.hpp"
#include "tools/parlour/voice_test/spoken_lines.hpp"
#include "tools/parlour/voice_test/voice_report.hpp"

namespace parlour::tools {

namespace {

using Results = std::vector<ConversationResult>;

// Runs all conversations. Each has its own node and its own coverage, so they
// share nothing that changes. The results are in the order of the suite,
// whatever the threads do.
Results hold_all(const Application& application, const TestSuite& suite,
                 const TestOptions& options, SpokenSeats* seats,
                 Coverage& coverage) {
  Results results(suite.conversations.size());
  std::vector<Coverage> seen(results.size(), coverage);
  const HoldOptions hold{options.update ? Words::any : Words::as_written,
                         options.restores, seats};
  Witness witness;
  in_parallel(results.size(), options.jobs, [&](std::size_t i) {
    const auto& conversation = suite.conversations[i];
    const Witness::Held held(witness, conversation.file);
    results[i] = hold_conversation(application, conversation, seen[i], hold);
  });
  for (const auto& part : seen)
    coverage.add(part);
  return results;
}

// Writes the JUnit file, if one is wanted. False if that fails.
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

// Replaces the robot's words in one conversation file.
Expected<void> rewrite(const std::filesystem::path& file,
                       const std::vector<Rewording>& rewordings) {
  const auto text = script::read_bytes(file);
  return text ? replace_file(file, reworded(*text, rewordings))
              : Expected<void>(tl::make_unexpected(text.error()));
}

// --update: rewrites the files with the words that the robot says now. A
// conversation with another kind of failure stays as it is.
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

// Warnings, too, stop the test: a conversation that runs into a known mistake
// proves nothing.
bool refused(const std::vector<script::Finding>& findings, const Places& places,
             const Console& console) {
  if (findings.empty())
    return false;
  print_lines(console.out, findings, places);
  say_error(console, "no conversation is held: " + to_string(count(findings)));
  return true;
}

// In a test the samples of a service's rules answer, and nobody needs a secret.
std::vector<script::Finding>
findings_for_test(std::vector<script::Finding> findings) {
  std::erase_if(findings, [](const script::Finding& finding) {
    return finding.name == "missing-secret";
  });
  return findings;
}

// Runs the suite and prints everything about it.
int hold_and_report(const Application& application, const TestSuite& suite,
                    const Places& places, const TestOptions& options,
                    const Console& console) {
  std::optional<SpokenLines> lines;
  if (is_spoken(suite)) {
    auto spoken = open_application(places, options.app, console,
                                   VoiceWishes{"user.wav", "robot.wav"});
    if (const auto* status = std::get_if<int>(&spoken))
      return *status;
    lines.emplace(std::get<Application>(std::move(spoken)), suite,
                  application.plugins);
    if (refused(lines->findings(), places, console))
      return exit_code::wrong;
  }
  Coverage coverage(*application.program);
  const auto results = hold_all(application, suite, options,
                                lines ? &*lines : nullptr, coverage);
  // Write the file before anything is printed: the reader of our output may go
  // away, and the file is to be complete then.
  const auto written = write_junit(options, application.program->settings.name,
                                   results, console);
  print_failures(console.out, results, options.trace);
  const auto updated = update_files(suite, results, console);
  if (!options.quiet)
    print(console.out, coverage, places);
  print_summary(console.out, results);
  return updated && written && all_passed(results) ? exit_code::success
                                                   : exit_code::wrong;
}

// --voice: holds the suite by voice. The files of microphone and speaker are
// never opened (voice_test/row_runner).
int hold_by_voice_and_report(const Application& application,
                             const TestSuite& suite, const Places& places,
                             const TestOptions& options,
                             const Console& console) {
  const auto noise = read_noise(options.noise);
  if (!noise) {
    say_error(console, noise.error().message);
    return exit_code::usage;
  }
  VoiceWishes seat{"user.wav", "robot.wav"};
  seat.recogniser = options.recogniser;
  const auto opened = open_application(places, options.app, console, seat);
  if (const auto* status = std::get_if<int>(&opened))
    return *status;
  const VoiceWish wish{options.voices, *noise, options.told, options.jobs};
  const auto results =
      hold_by_voices(application, std::get<Application>(opened), suite, wish,
                     application.plugins);
  if (!results) {
    say_error(console, results.error().message);
    return exit_code::usage;
  }
  if (!options.quiet)
    print_rows(console.out, *results, options.trace);
  print_scores(console.out, *results, wish);
  return all_as_by_text(*results) ? exit_code::success : exit_code::wrong;
}

// One test run, from opening the application to the summary.
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
  if (refused(findings_for_test(application.findings), places, console) ||
      refused(suite->findings, places, console))
    return exit_code::wrong;
  if (suite->conversations.empty()) {
    say_error(console, options.app + " has no conversations: nothing was "
                                     "tested; write one into dialogues/, a "
                                     "file that ends in .txt");
    return exit_code::wrong;
  }
  return options.voice
             ? hold_by_voice_and_report(application, *suite, places, options,
                                        console)
             : hold_and_report(application, *suite, places, options, console);
}

// --watch: tests again after each change, until Ctrl-C. Changes while the
// conversations run are not lost: the next wait returns at once.
int test_again_and_again(const Places& places, const TestOptions& options,
                         const Console& console) {
  SignalWatch signals;
  // Watch the application, the platform's files, and conversations elsewhere.
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
      return exit_code::success; // the caller reports it
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
