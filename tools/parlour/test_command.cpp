#include <algorithm>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <thread>

#include "tools/parlour/commands.hpp"
#include "tools/parlour/conversation_check.hpp"
#include "tools/parlour/conversation_runner.hpp"
#include "tools/parlour/exit_code.hpp"
#include "tools/parlour/finding_text.hpp"
#include "tools/parlour/junit.hpp"
#include "tools/parlour/opening.hpp"
#include "tools/parlour/report.hpp"

namespace parlour::tools {

namespace fs = std::filesystem;

namespace {

using Paths = std::vector<fs::path>;

bool is_file(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

Paths all_files(const Application& application) {
  Paths files;
  std::error_code ignored;
  for (const auto& entry :
       fs::directory_iterator(application.folder / "dialogues", ignored))
    if (entry.path().extension() == ".txt")
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

// A path, or the name of one of the application's conversations.
fs::path find_file(const Places& places, const Application& application,
                   const std::string& name) {
  const auto dialogues = application.folder / "dialogues";
  for (const auto& path :
       {places.working / name, dialogues / name, dialogues / (name + ".txt")})
    if (is_file(path))
      return path;
  return {};
}

Expected<Paths> chosen_files(const Places& places,
                             const Application& application,
                             const TestOptions& options) {
  if (options.files.empty())
    return all_files(application);
  Paths files;
  for (const auto& name : options.files) {
    auto path = find_file(places, application, name);
    if (path.empty())
      return fail(ErrorKind::settings,
                  "there is no conversation '" + name +
                      "', neither as a file nor in " +
                      (application.folder / "dialogues").string());
    files.push_back(std::move(path));
  }
  return files;
}

struct Suite {
  std::vector<Conversation> conversations;
  std::vector<script::Finding> findings;
};

Suite read_suite(const Application& application, const Paths& files,
                 const Places& places) {
  Suite suite;
  for (const auto& file : files) {
    auto parsed = read_conversation(file);
    const auto wrong =
        check_conversation(parsed.conversation, *application.program);
    suite.findings.insert(suite.findings.end(), parsed.errors.begin(),
                          parsed.errors.end());
    suite.findings.insert(suite.findings.end(), wrong.begin(), wrong.end());
    parsed.conversation.file = shown_path(places, parsed.conversation.file);
    suite.conversations.push_back(std::move(parsed.conversation));
  }
  return suite;
}

// Conversations are shared out among threads; each has its own node.
std::vector<ConversationResult> hold_all(const Application& application,
                                         const Suite& suite, unsigned jobs,
                                         Coverage& coverage) {
  std::vector<ConversationResult> results(suite.conversations.size());
  std::vector<Coverage> seen(results.size(), coverage);
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < results.size(); i = next++)
      results[i] =
          hold_conversation(application, suite.conversations[i], seen[i]);
  };
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
                 const std::vector<ConversationResult>& results,
                 const Console& console) {
  if (options.junit.empty())
    return true;
  std::ofstream file(options.junit, std::ios::binary);
  print_junit(file, name, results);
  file.close();
  if (!file)
    say_error(console, options.junit + " cannot be written");
  return !!file;
}

bool all_passed(const std::vector<ConversationResult>& results) {
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

} // namespace

int test_command(const Places& places, const TestOptions& options,
                 const Console& console) {
  auto opened = open_application(places, options.app, console);
  if (const auto* status = std::get_if<int>(&opened))
    return *status;
  const auto& application = std::get<Application>(opened);
  const auto files = chosen_files(places, application, options);
  if (!files) {
    say_error(console, files.error().message);
    return exit_code::usage;
  }
  const auto suite = read_suite(application, *files, places);
  if (refused(application.findings, places, console) ||
      refused(suite.findings, places, console))
    return exit_code::wrong;
  if (suite.conversations.empty()) {
    say_error(console, options.app + " has no conversations: nothing was "
                                     "tested; write one into dialogues/, a "
                                     "file that ends in .txt");
    return exit_code::wrong;
  }
  Coverage coverage(*application.program);
  const auto jobs = options.jobs
                        ? options.jobs
                        : std::max(1u, std::thread::hardware_concurrency());
  const auto results = hold_all(application, suite, jobs, coverage);
  print_failures(console.out, results, options.trace);
  if (!options.quiet)
    print(console.out, coverage, places);
  print_summary(console.out, results);
  const auto written = write_junit(options, application.program->settings.name,
                                   results, console);
  return written && all_passed(results) ? exit_code::well : exit_code::wrong;
}

} // namespace parlour::tools
