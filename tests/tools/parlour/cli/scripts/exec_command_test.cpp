#include "tests/support/temporary_folder.hpp"
#include "tests/tools/parlour/command_fixture.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;

TEST_F(CommandTest, exec_runs_main) {
  EXPECT_EQ(call({"exec", "greeter/greeter.xml"}), exit_code::success);
  EXPECT_EQ(out_.str(), "two is 2\n");
}

TEST_F(CommandTest, exec_shows_compiled_code_and_runs_nothing) {
  EXPECT_EQ(call({"exec", "--listing", "greeter/greeter.xml"}),
            exit_code::success);
  EXPECT_THAT(out_.str(), HasSubstr("function main: 0 of 0 parameters needed"));
  EXPECT_THAT(out_.str(), HasSubstr("end with unknown\n"));
  EXPECT_THAT(out_.str(), testing::Not(HasSubstr("two is 2\n")));
}

TEST_F(CommandTest, exec_prints_an_error_with_its_place) {
  test::TemporaryFolder folder;
  folder.write("x.xml", "<dialogue><function name=\"main\">\n"
                        "<print param=\"{1 / 0}\"/></function></dialogue>");
  EXPECT_EQ(call({"exec", (folder.path() / "x.xml").string()}),
            exit_code::wrong);
  EXPECT_THAT(err_.str(), HasSubstr("x.xml:2: "));
}

TEST_F(CommandTest, exec_prints_the_script_s_stack) {
  test::TemporaryFolder folder;
  folder.write("x.xml", "<dialogue>\n<function name=\"inner\">\n"
                        "<throw expr=\"'out of order'\"/></function>\n"
                        "<function name=\"main\">\n"
                        "<call function=\"inner\"/></function></dialogue>");
  places_.working = folder.path();
  EXPECT_EQ(call({"exec", "x.xml"}), exit_code::wrong);
  EXPECT_EQ(err_.str(), "x.xml:3: out of order\n"
                        "  in function inner (x.xml:3)\n"
                        "  in function main (x.xml:5)\n");
}

TEST_F(CommandTest, exec_knows_a_file_that_is_not_there) {
  EXPECT_EQ(call({"exec", "none.xml"}), exit_code::usage);
}

} // namespace
} // namespace parlour::tools
