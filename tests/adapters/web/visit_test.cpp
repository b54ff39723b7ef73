#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/web/bounds.hpp"
#include "adapters/web/visit.hpp"
#include "tests/adapters/web/fake_host.hpp"

namespace parlour::adapters::web {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class NotingVisit : public Visit {
public:
  using Visit::Visit;
  void send(std::string text) override {
    seen.push_back(std::move(text));
  }
  void shut() override {
    seen.push_back("shut");
  }
  std::vector<std::string> take() {
    return std::exchange(seen, {});
  }
  std::vector<std::string> seen;
};

class VisitTest : public testing::Test {
protected:
  VisitTest() {
    host.teller = &book;
  }
  ~VisitTest() override {
    visit.lost(host.now);
    other.lost(host.now);
  }

  test::FakeHost<VisitorBook> host;
  VisitorBook book{{1, Milliseconds(100)}, host};
  NotingVisit visit{book};
  NotingVisit other{book};
};

TEST_F(VisitTest, APersonTypes) {
  visit.begin_typed();
  visit.hear_line("one\r");
  visit.hear_line("  ");
  visit.hear_line("{two");
  EXPECT_THAT(visit.seen, ElementsAre("Hello.", "echo: one", "echo: {two"));
  EXPECT_EQ(book.counters().turns, 2);
}

// It is no words of a person, and nobody is to act on them.
TEST_F(VisitTest, AProgramThatBeginsTooLateIsSentAway) {
  visit.begin_typed();
  visit.hear_line(R"({"type": "hello", "version": 1})");
  EXPECT_THAT(visit.seen,
              ElementsAre("Hello.", HasSubstr("connect again"), "shut"));
  EXPECT_EQ(book.counters().turns, 0);
}

TEST_F(VisitTest, TheFirstLineTellsWhoItIs) {
  visit.hear_line("one");
  EXPECT_THAT(visit.take(), ElementsAre("Hello.", "echo: one"));
  other.hear_line(R"({"type": "ping"})");
  EXPECT_THAT(other.take(), ElementsAre(R"({"type": "pong"})"));
}

TEST_F(VisitTest, APersonIsToldWhichByteIsWrong) {
  visit.begin_typed();
  visit.take();
  visit.hear_line("one");
  visit.hear_line("tw\xff");
  EXPECT_THAT(visit.seen.back(),
              HasSubstr("! line 2: byte 3 of this line is no UTF-8"));
}

TEST_F(VisitTest, APersonIsReadNoFasterThanAnswered) {
  visit.begin_typed();
  for (std::size_t i = 0; i < max_open_turns; ++i) {
    EXPECT_FALSE(visit.is_full());
    visit.hear_line("wait");
  }
  EXPECT_TRUE(visit.is_full());
  host.answer(1, 1);
  EXPECT_FALSE(visit.is_full());
}

TEST_F(VisitTest, WhoSaysNoMoreIsStillAnswered) {
  visit.begin_typed();
  visit.hear_line("wait");
  visit.take();
  visit.hear_end();
  EXPECT_THAT(visit.seen, IsEmpty());
  host.say(1, "at last");
  host.answer(1, 1);
  EXPECT_THAT(visit.take(), ElementsAre("at last", "shut"));
  EXPECT_EQ(book.size(), 0);
}

TEST_F(VisitTest, AProgramSaysHelloOnceAndFirst) {
  visit.hear_message(R"({"type": "turn", "turn": 1, "say": "one"})");
  EXPECT_THAT(visit.take(), ElementsAre(HasSubstr("say hello first")));
  visit.hear_message(R"({"type": "hello"})");
  EXPECT_THAT(visit.take(),
              ElementsAre(HasSubstr("welcome"), HasSubstr("Hello.")));
  visit.hear_message(R"({"type": "hello"})");
  EXPECT_THAT(visit.take(), ElementsAre(HasSubstr("hello was said already")));
  visit.hear_message(R"({"type": "turn", "turn": 1, "say": "one"})");
  EXPECT_THAT(visit.take(),
              ElementsAre(HasSubstr("echo: one"), HasSubstr("done")));
  visit.hear_message("nonsense");
  EXPECT_THAT(visit.take(), ElementsAre(HasSubstr("this is no JSON")));
  visit.hear_message(R"({"type": "end"})");
  EXPECT_THAT(visit.take(), ElementsAre(R"({"type": "end"})", "shut"));
  visit.hear_message(R"({"type": "ping"})"); // it is not heard any more
  EXPECT_THAT(visit.take(), IsEmpty());
}

TEST_F(VisitTest, WhoIsNotLetInIsToldAndLeaves) {
  visit.begin_typed();
  other.begin_typed();
  EXPECT_THAT(other.take(),
              ElementsAre("! all 1 places are taken; try again later", "shut"));
  NotingVisit third(book);
  third.hear_message(R"({"type": "hello"})");
  EXPECT_THAT(third.take(), ElementsAre(HasSubstr("\"full\""), "shut"));
}

TEST_F(VisitTest, WhoLeavesWithoutHelloMayGo) {
  visit.hear_message(R"({"type": "end"})");
  EXPECT_THAT(visit.take(), ElementsAre("shut"));
}

} // namespace
} // namespace parlour::adapters::web
