#include "tests/tools/parlour/command_fixture.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;

TEST_F(CommandTest, understand_prints_the_words_the_way_and_the_acts) {
  EXPECT_EQ(call({"understand", "bicycles",
                  "I would like to rent a tandem for three days"}),
            exit_code::success);
  EXPECT_THAT(out_.str(), HasSubstr("tokens i would like"));
  EXPECT_THAT(out_.str(), HasSubstr("Kind: {value: tandem,"));
  EXPECT_THAT(out_.str(), HasSubstr("Days: {value: 3,"));
  EXPECT_EQ(err_.str(), "");
}

TEST_F(CommandTest, understand_says_what_it_did_not_understand) {
  EXPECT_EQ(call({"understand", "bicycles", "zxqv"}), exit_code::success);
  EXPECT_THAT(out_.str(), HasSubstr("not understood: NoResult\nscore 0\n"));
}

TEST_F(CommandTest, understand_wants_the_components_that_understand) {
  EXPECT_EQ(call({"understand", "greeter", "hello"}), exit_code::wrong);
  EXPECT_EQ(err_.str(), "error: greeter has no GrammarNLU to ask\n");
}

} // namespace
} // namespace parlour::tools
