#include "tests/support/temporary_folder.hpp"
#include "tests/tools/parlour/command_fixture.hpp"
#include "tools/parlour/cli/commands.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;

class FormatCommandTest : public CommandTest {
protected:
  FormatCommandTest() {
    places_.working = folder_.path();
    folder_.write("a.xml", untidy);
    folder_.write("b.xml", tidy);
    folder_.write("c.xml", "<a><b></a>");
  }
  int format(const FormatOptions& options, const std::string& input = "") {
    std::istringstream in(input);
    return format_command(places_, options, in, {out_, err_});
  }

  static constexpr const char* untidy = "<a>\n<b/></a>";
  static constexpr const char* tidy = "<a>\n  <b/>\n</a>\n";
  test::TemporaryFolder folder_;
};

TEST_F(FormatCommandTest, lays_files_out_where_they_are) {
  EXPECT_EQ(call({"format", "a.xml", "b.xml"}), exit_code::success);
  EXPECT_EQ(folder_.read("a.xml"), tidy);
  EXPECT_EQ(folder_.read("b.xml"), tidy);
  EXPECT_EQ(out_.str() + err_.str(), "");
}

TEST_F(FormatCommandTest, only_says_which_are_not_laid_out) {
  EXPECT_EQ(call({"format", "--check", "b.xml"}), exit_code::success);
  EXPECT_EQ(call({"format", "--check", "a.xml", "b.xml"}), exit_code::wrong);
  EXPECT_EQ(err_.str(), "a.xml: not formatted\n");
  EXPECT_EQ(folder_.read("a.xml"), untidy);
}

TEST_F(FormatCommandTest, passes_standard_input_through) {
  EXPECT_EQ(format({{"-"}, false}, untidy), exit_code::success);
  EXPECT_EQ(out_.str(), tidy);
  EXPECT_EQ(format({{"-"}, true}, untidy), exit_code::wrong);
}

TEST_F(FormatCommandTest, leaves_alone_what_it_cannot_read) {
  EXPECT_EQ(call({"format", "c.xml", "a.xml"}), exit_code::wrong);
  EXPECT_THAT(err_.str(), HasSubstr("c.xml:1:7: error: </a> does not fit"));
  EXPECT_EQ(folder_.read("c.xml"), "<a><b></a>");
  EXPECT_EQ(folder_.read("a.xml"), tidy);
  EXPECT_EQ(call({"format", "nobody.xml"}), exit_code::usage);
}

} // namespace
} // namespace parlour::tools
