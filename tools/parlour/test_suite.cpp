#include "tools/parlour/test_suite.hpp"

#include <algorithm>

#include "tools/parlour/conversation_check.hpp"

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
                             const std::vector<std::string>& names) {
  if (names.empty())
    return all_files(application);
  Paths files;
  for (const auto& name : names) {
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
  for (const auto& file : suite.files) {
    auto parsed = read_conversation(file);
    add(parsed.errors);
    add(check_conversation(parsed.conversation, *application.program));
    parsed.conversation.file = shown_path(places, parsed.conversation.file);
    suite.conversations.push_back(std::move(parsed.conversation));
  }
  return suite;
}

} // namespace parlour::tools
