// private="true": the value is masked in every place where it could be shown.
#include <cstdio>
#include <sstream>

#include "tests/support/temporary_folder.hpp"
#include "tests/tools/parlour/command_fixture.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;
using testing::Not;

const char* const secrets[] = {"4711",     "four seven",   "four thousand",
                               "91234567", "nine one two", "open sesame"};

void expect_no_secret(const std::string& seen) {
  for (const auto* secret : secrets)
    EXPECT_THAT(seen, Not(HasSubstr(secret)));
}

// Runs the conversation of vault/dialogues; returns what standard error gets.
std::string errors_of(const std::string& arguments) {
  const auto command =
      "printf 'open it and call 91234567\\n\\n4711\\n\\nyes\\n\\n' "
      "| " +
      test::program_path() + " run " + arguments +
      " --clock '2026-11-21 09:00' 2>&1 >/dev/null";
  auto* pipe = popen(command.c_str(), "r");
  std::string all;
  char buffer[4096];
  while (const auto size = fread(buffer, 1, sizeof buffer, pipe))
    all.append(buffer, size);
  pclose(pipe);
  return all;
}

class PrivacyTest : public CommandTest {
protected:
  std::string vault() const {
    return application("vault") + " --data " + folder_.path().string();
  }
  // Without the words of the file itself.
  static std::string without_turns(const std::string& report) {
    std::istringstream lines(report);
    std::string rest;
    for (std::string line; std::getline(lines, line);)
      if (!line.starts_with("    U: ") && !line.starts_with("  expected: "))
        rest += line + '\n';
    return rest;
  }
  std::string failing(const std::string& expectation) {
    test::TemporaryFolder folder;
    folder.write("fails.txt",
                 "U: open it and call 91234567\nU: 4711\nU: yes\n" +
                     expectation + "\n");
    call({"test", application("vault"), (folder.path() / "fails.txt").string(),
          "--trace"});
    EXPECT_THAT(out_.str(), HasSubstr("FAILED"));
    return without_turns(out_.str());
  }

  test::TemporaryFolder folder_;
};

TEST_F(PrivacyTest, a_trace_masks_it) {
  const auto seen = errors_of(vault() + " --trace");
  expect_no_secret(seen);
  EXPECT_THAT(seen, HasSubstr("RecognitionResult(***"));
  EXPECT_THAT(seen, HasSubstr("your PIN is ***"));
  EXPECT_THAT(seen, HasSubstr("opening with ***"));
  EXPECT_THAT(seen, HasSubstr("no use for *** and ***"));
  EXPECT_THAT(seen,
              HasSubstr("Query(insert into entry (pin) values (?), [***]"));
}

TEST_F(PrivacyTest, logs_and_errors_mask_it) {
  const auto seen = errors_of(vault());
  expect_no_secret(seen);
  EXPECT_THAT(seen, HasSubstr("entries: [***]"));
  EXPECT_THAT(seen, HasSubstr("no use for ***"));
}

TEST_F(PrivacyTest, conversations_use_it) {
  EXPECT_EQ(call({"test", "vault", "-q"}), exit_code::success) << out_.str();
}

TEST_F(PrivacyTest, reports_mask_it) {
  expect_no_secret(failing("R: Something else."));
  expect_no_secret(failing("expect slot Open.Pin = 1"));
  expect_no_secret(failing("expect post SMS Send 1"));
  expect_no_secret(failing("expect sql select pin from entry = 1"));
}

} // namespace
} // namespace parlour::tools
