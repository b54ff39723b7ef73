// Values of a table that change while a conversation goes on (engine rule 1.9).
#include "tests/tools/parlour/application_fixture.hpp"
#include "tools/parlour/conversation_test/conversation_runner.hpp"

namespace parlour::tools {
namespace {

using testing::Contains;
using testing::HasSubstr;

class ChangedTableTest : public ApplicationTest {
protected:
  ConversationResult hold(const std::string& text) {
    const auto parsed = parse_conversation(text, "x.txt");
    EXPECT_TRUE(parsed.errors.empty());
    auto result = hold_conversation(newcomers_, parsed.conversation, coverage_);
    EXPECT_FALSE(result.failure)
        << result.failure->line << ": " << result.failure->found;
    return result;
  }

  Application newcomers_ = load("newcomers");
  Coverage coverage_{*newcomers_.program};
};

TEST_F(ChangedTableTest, is_understood_in_the_next_turn) {
  const auto result =
      hold("R: Hello.\n"
           "U: call Deborah Winter\n"
           "R: I am sorry, Deborah Winter is not possible here.\n"
           "R: Whom shall I call?\n"
           "U: Deborah joins\n"
           "R: Done.\n"
           "U: call Deborah Winter\n"
           "R: I call Deborah Winter.\n"
           "U: call Jeffery\n"
           "R: I call Jeffery Ho.\n"
           "U: Deborah leaves\n"
           "R: Done.\n"
           "U: call Deborah Winter\n"
           "R: I am sorry, Deborah Winter is not possible here.\n"
           "R: Whom shall I call?\n");
  EXPECT_THAT(result.trace,
              Contains(HasSubstr("ValuesChanged(db:staff.name, [Deborah "
                                 "Winter, Jeffery Ho, Siti Aminah])")));
  EXPECT_THAT(result.trace, Contains(HasSubstr("SetValues(db:staff.name")));
}

TEST_F(ChangedTableTest, is_understood_after_a_transaction) {
  hold("R: Hello.\n"
       "U: Deborah joins\n"
       "R: Done.\n"
       "U: Deborah marries\n"
       "R: Done.\n"
       "U: call Deborah Summer\n"
       "R: I call Deborah Summer.\n");
}

} // namespace
} // namespace parlour::tools
