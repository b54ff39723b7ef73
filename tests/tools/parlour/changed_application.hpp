// ChangedApplication: copies one of our applications, changes some lines and
// runs its conversations.
#pragma once

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "tests/support/paths.hpp"
#include "tests/tools/parlour/application_fixture.hpp"
#include "tools/parlour/conversation_test/conversation_runner.hpp"

namespace parlour::tools {

class ChangedApplication : public ApplicationTest {
protected:
  // Components with host="process" run in the program, not in the test.
  ChangedApplication() {
    setenv("PARLOUR_PROGRAM", test::program_path().c_str(), 1);
  }

  // Without its wordings: to learn them takes a second at each start, and many
  // under sanitizers.
  void copy(const std::string& application) {
    std::filesystem::copy(test::source_path("config/apps/") + application,
                          folder_.path(),
                          std::filesystem::copy_options::recursive);
    folder_.write("wordings.tsv", "");
  }
  void change(const std::string& file, const std::string& from,
              const std::string& to) {
    auto text = read(folder_.path() / file);
    const auto at = text.find(from);
    if (at == std::string::npos)
      throw std::runtime_error(file + " has no " + from);
    folder_.write(file, text.replace(at, from.size(), to));
  }
  Application load_changed() const {
    return load_application(std::filesystem::canonical(folder_.path()),
                            platform());
  }

  // Runs a conversation; empty if it passed.
  std::string hold(const Application& application,
                   const std::string& conversation) {
    if (application.has_errors())
      return findings(application);
    const auto file = folder_.path() / "dialogues" / conversation;
    const auto parsed = parse_conversation(read(file), file.string());
    Coverage coverage{*application.program};
    result = hold_conversation(application, parsed.conversation, coverage);
    if (!result.failure)
      return "";
    return conversation + ":" + std::to_string(result.failure->line) +
           ": expected " + result.failure->expected + ", found " +
           result.failure->found;
  }

  static std::string read(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  ConversationResult result;
};

} // namespace parlour::tools
