// Finds the files of a test run and parses them.
#include "tools/parlour/conversation_test/test_suite.hpp"

#include <algorithm>

#include "runtime/base/outside/file_bytes.hpp"
#include "tools/parlour/conversation_test/conversation_check.hpp"

namespace parlour::tools {

namespace fs = std::filesystem;

namespace {

using Paths = std::vector<fs::path>;

// All .txt files in dialogues/, sorted; none if there is no such folder.
Expected<Paths> all_files(const Application& application) {
  const auto dialogues = application.folder / "dialogues";
  return is_there(dialogues) ? list_files(dialogues, ".txt") : Paths();
}

// A path, relative to the working folder or to the application, or a name in
// dialogues/ with or without ".txt".
Expected<fs::path> find_file(const Places& places,
                             const Application& application,
                             const std::string& name) {
  const auto dialogues = application.folder / "dialogues";
  const Paths candidates{places.working / name, application.folder / name,
                         dialogues / name, dialogues / (name + ".txt")};
  for (const auto& path : candidates)
    if (check_is_file(path))
      return path;
  // Explains why something of that name cannot be read, such as a folder.
  for (const auto& path : candidates)
    if (is_there(path) && !name.empty())
      return tl::make_unexpected(check_is_file(path).error());
  return fail(ErrorKind::settings, "there is no conversation '" + name +
                                       "', neither as a file nor in " +
                                       dialogues.string());
}

// All conversations of the application, or those that were named.
Expected<Paths> chosen_files(const Places& places,
                             const Application& application,
                             const std::vector<std::string>& names) {
  if (names.empty())
    return all_files(application);
  Paths files;
  for (const auto& name : names) {
    auto path = find_file(places, application, name);
    if (!path)
      return tl::make_unexpected(path.error());
    files.push_back(std::move(*path));
  }
  return files;
}

} // namespace

Expected<TestSuite> read_suite(const Application& application,
                               const std::vector<std::string>& names,
                               const Places& places) {
  auto files = chosen_files(places, application, names);
  if (!files)
    return tl::make_unexpected(files.error());
  TestSuite suite;
  suite.files = std::move(*files);
  auto add = [&](const std::vector<script::Finding>& findings) {
    suite.findings.insert(suite.findings.end(), findings.begin(),
                          findings.end());
  };
  // A file with errors stays in the suite; the caller runs nothing if there
  // are findings.
  for (const auto& file : suite.files) {
    auto parsed = read_conversation(file);
    add(parsed.errors);
    add(check_conversation(parsed.conversation, *application.program));
    // Shown paths are relative to the working folder, as in all output.
    parsed.conversation.file = shown_path(places, parsed.conversation.file);
    suite.conversations.push_back(std::move(parsed.conversation));
  }
  return suite;
}

} // namespace parlour::tools
