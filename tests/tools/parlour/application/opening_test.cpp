#include "tests/tools/parlour/command_fixture.hpp"
#include "tools/parlour/application/opening.hpp"

namespace parlour::tools {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

TEST_F(CommandTest, opening_gives_a_sound_application) {
  const auto opened = open_application(places_, "greeter", {out_, err_});
  ASSERT_TRUE(std::holds_alternative<Application>(opened));
  EXPECT_TRUE(std::get<Application>(opened).program);
  EXPECT_EQ(out_.str() + err_.str(), "");
}

TEST_F(CommandTest, opening_says_what_is_wrong_and_which_status_that_is) {
  auto opened = open_application(places_, "bad-option", {out_, err_});
  EXPECT_EQ(std::get<int>(opened), exit_code::wrong);
  EXPECT_THAT(err_.str(), testing::StartsWith("bad-option/settings.xml:"));
  EXPECT_THAT(err_.str(), EndsWith("error: bad-option is not started: "
                                   "2 errors, 0 warnings\n"));
  opened = open_application(places_, "nobody", {out_, err_});
  EXPECT_EQ(std::get<int>(opened), exit_code::usage);
  EXPECT_THAT(err_.str(), HasSubstr("error: there is no application 'nobody'"));
  EXPECT_EQ(out_.str(), "");
}

} // namespace
} // namespace parlour::tools
