#include "tests/tools/parlour/load/load_fixture.hpp"

namespace parlour::tools {
namespace {

using testing::Contains;
using testing::HasSubstr;

class LoadRunTest : public LoadTest {
protected:
  LoadRunTest() {
    add("R: Hello.\nU: one\nR: echo: one\n");
    add("R: Hello.\nU: two\nR: echo: two\nU: end\nR: echo: end\n");
  }
};

TEST_F(LoadRunTest, EachVisitorPlaysOne) {
  run({.visitors = 200, .rate = {}, .duration = {}});
  EXPECT_TRUE(figures.all_right());
  EXPECT_EQ(figures.conversations(), 200);
  EXPECT_EQ(figures.turns(), 300);
}

TEST_F(LoadRunTest, VisitorsComeByARate) {
  run({.visitors = 100, .rate = 100, .duration = Milliseconds(500)});
  EXPECT_TRUE(figures.all_right());
  // Fewer where the machine is busy; all at once would be 100.
  EXPECT_LE(figures.conversations(), 50);
  EXPECT_GT(figures.conversations(), 0);
}

TEST_F(LoadRunTest, ARateThatIsTooHighIsToldAndBounded) {
  host.begins = false; // nobody is greeted
  parts.patience = Milliseconds(1);
  const auto lines =
      run({.visitors = 2, .rate = 1'000, .duration = Milliseconds(20)});
  EXPECT_THAT(lines, Contains(HasSubstr("slower than --rate")));
}

TEST_F(LoadRunTest, VisitorsBeginAnotherUntilTheTimeIsOver) {
  run({.visitors = 3, .rate = {}, .duration = Milliseconds(500)});
  EXPECT_TRUE(figures.all_right());
  EXPECT_GT(figures.conversations(), 3);
  EXPECT_EQ(server->counts().sessions, 0); // nobody keeps a place
}

TEST_F(LoadRunTest, IdleVisitorsSayNothing) {
  parts.idle = true;
  LoadRun one(parts, conversations,
              {.visitors = 20, .rate = {}, .duration = {}, .idle = true}, {});
  one.run();
  EXPECT_EQ(figures.turns(), 0);
  EXPECT_EQ(one.most_visitors(), 20);
  EXPECT_GT(one.memory_before(), 0);
  EXPECT_EQ(server->counts().sessions, 20);
}

} // namespace
} // namespace parlour::tools
