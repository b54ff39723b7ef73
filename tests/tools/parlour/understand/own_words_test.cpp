#include "tests/tools/parlour/application_fixture.hpp"
#include "tools/parlour/understand/own_words.hpp"

namespace parlour::tools {
namespace {

class OwnWordsTest : public ApplicationTest {
protected:
  auto start(const std::string& handler) const {
    folder_.write("own.xml",
                  "<dialogue><var name=\"said\" expr=\"''\"/><handler "
                  "name=\"Own\"><messages><component><ASR>"
                  "<RecognitionResult>" +
                      handler +
                      "</RecognitionResult></ASR></component></messages>"
                      "</handler><state name=\"Start\"><Entrance>"
                      "<speak param=\"Hello\"/></Entrance></state></dialogue>");
    application_ = load_application(std::filesystem::canonical(folder_.path()),
                                    platform());
    EXPECT_EQ(findings(application_), "");
    return OwnWords::start(application_, *parse_timestamp("2026-11-24 09:00"));
  }

  mutable Application application_;
};

TEST_F(OwnWordsTest, are_what_the_handler_makes_of_them) {
  auto own = start("<var name=\"text\" expr=\"_LPARAM1 + ' Jeffery'\"/>"
                   "<post module=\"NLU\" command=\"DoNLU\" param=\"text\"/>");
  ASSERT_TRUE(own) << to_string(own.error());
  for (int time = 0; time < 3; ++time) {
    const auto sent = (*own)->say("for Jeff");
    ASSERT_TRUE(sent);
    EXPECT_EQ(sent->text, "for Jeff Jeffery");
    EXPECT_EQ((*sent->context.find("now")),
              Value(*parse_timestamp("2026-11-24 09:00")));
  }
}

// What the sentence before left behind would change what this one means.
TEST_F(OwnWordsTest, are_said_in_a_conversation_of_their_own) {
  auto own = start("<post module=\"NLU\" command=\"DoNLU\" "
                   "param=\"_LPARAM1 + said\"/>"
                   "<set name=\"said\" expr=\"' again'\"/>");
  ASSERT_TRUE(own) << to_string(own.error());
  for (int time = 0; time < 4; ++time) {
    const auto sent = (*own)->say("hello");
    ASSERT_TRUE(sent);
    EXPECT_EQ(sent->text, "hello");
  }
}

TEST_F(OwnWordsTest, are_none_where_the_handler_keeps_them) {
  auto own = start("<if cond=\"_LPARAM1 != 'secret'\">"
                   "<post module=\"NLU\" command=\"DoNLU\" "
                   "param=\"_LPARAM1\"/></if>");
  ASSERT_TRUE(own) << to_string(own.error());
  EXPECT_FALSE((*own)->say("secret"));
  EXPECT_TRUE((*own)->say("open"));
}

} // namespace
} // namespace parlour::tools
