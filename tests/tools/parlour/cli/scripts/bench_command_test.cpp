#include <filesystem>

#include "tests/support/temporary_folder.hpp"
#include "tests/tools/parlour/command_fixture.hpp"

namespace parlour::tools {
namespace {

using testing::ExitedWithCode;
using testing::HasSubstr;

namespace fs = std::filesystem;

TEST_F(CommandTest, bench_says_how_benches_are_built_where_there_are_none) {
  const test::TemporaryFolder folder;
  places_.programs = folder.path();
  EXPECT_EQ(call({"bench", "script", "--runs", "1"}), exit_code::usage);
  EXPECT_THAT(err_.str(), HasSubstr("tools/bench/run NAME"));
}

TEST_F(CommandTest, bench_hands_its_arguments_over) {
  const test::TemporaryFolder folder;
  folder.write("parlour-bench", "#!/bin/sh\n"
                                "echo \"$*\" >&2\n"
                                "exit 7\n");
  fs::permissions(folder.path() / "parlour-bench", fs::perms::owner_all);
  places_.programs = folder.path();
  EXPECT_EXIT(call({"bench", "script", "--only", "calls"}), ExitedWithCode(7),
              "script --only calls");
}

TEST_F(CommandTest, bench_says_why_the_program_does_not_start) {
  const test::TemporaryFolder folder;
  folder.write("parlour-bench", "");
  places_.programs = folder.path();
  EXPECT_EQ(call({"bench"}), exit_code::wrong);
  EXPECT_THAT(err_.str(), HasSubstr("cannot be started: Permission denied"));
}

} // namespace
} // namespace parlour::tools
