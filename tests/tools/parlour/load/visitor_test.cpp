#include "tests/tools/parlour/load/load_fixture.hpp"

namespace parlour::tools {
namespace {

using testing::Contains;
using testing::HasSubstr;

class VisitorTest : public LoadTest {};

TEST_F(VisitorTest, ChecksEachAnswer) {
  add("R: Hello.\nU: one\nU: two\nR: echo: one\nR~ echo: t.*\nU: three\n"
      "R: echo: three\n");
  const auto lines = run({});
  EXPECT_EQ(figures.turns(), 2);
  EXPECT_EQ(figures.conversations(), 1);
  EXPECT_TRUE(figures.all_right());
}

// As in a test, a pattern may be about several outputs.
TEST_F(VisitorTest, APatternTakesAllThatItMatches) {
  add("R: Hello.\nU: one\nU: two\nR~ (?s).*two.*\nU: three\nU: four\n"
      "R~ (?s)echo: three.*\n");
  run({});
  EXPECT_EQ(figures.turns(), 2);
  EXPECT_TRUE(figures.all_right());
}

TEST_F(VisitorTest, TellsWhereAnAnswerIsWrong) {
  add("R: Hello.\nU: one\nR: echo: two\n");
  EXPECT_THAT(run({}), Contains("1 times: one.txt:3: expected R: echo: two, "
                                "found R: echo: one"));
}

TEST_F(VisitorTest, TellsWhereAnAnswerIsOneTooMany) {
  add("R: Hello.\nU: one\nU: two\nR: echo: one\nU: three\n");
  EXPECT_THAT(run({}), Contains("1 times: one.txt, after U: two: expected "
                                "nothing, found R: echo: two"));
}

TEST_F(VisitorTest, TellsWhereAnAnswerIsMissing) {
  parts.patience = Milliseconds(1);
  add("R: Hello.\nU: one\nR: echo: one\nR: More.\nU: two\n");
  EXPECT_THAT(run({}), Contains("1 times: one.txt:4: expected R: More., found "
                                "R: nothing"));
  add("R: Hello.\nU: wait\nR: At last.\n");
  conversations.erase(conversations.begin());
  EXPECT_THAT(run({}),
              Contains("1 times: one.txt: the server does not answer"));
}

TEST_F(VisitorTest, AfterTheEndAnotherVisitorGoesOn) {
  parts.by = web::TextClients::By::lines;
  add("R: Hello.\nU: end\nR: echo: end\nU: one\nR: Hello.\nR: echo: one\n");
  run({});
  EXPECT_TRUE(figures.all_right());
  EXPECT_EQ(server->counts().book.visitors, 2);
}

TEST_F(VisitorTest, TellsThatThereIsNoServer) {
  server = nullptr;
  add("R: Hello.\n");
  EXPECT_THAT(run({}), Contains(HasSubstr("the connection is over")));
}

} // namespace
} // namespace parlour::tools
