#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/web/bounds.hpp"
#include "adapters/web/visitor_book.hpp"
#include "tests/adapters/web/fake_host.hpp"

namespace parlour::adapters::web {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// Notes what it is told, as short texts.
class Noting : public Connection {
public:
  void tell(const Told& told) override {
    if (const auto* said = std::get_if<Said>(&told))
      seen.push_back(std::to_string(said->turn) + " " + said->text);
    else if (const auto* done = std::get_if<Done>(&told))
      seen.push_back("done " + std::to_string(done->turn));
    else if (const auto* welcome = std::get_if<Welcome>(&told))
      seen.push_back(
          "welcome " + welcome->session + " " + std::to_string(welcome->turn) +
          (welcome->resumed ? " again" : "") + (welcome->lost ? " lost" : ""));
    else if (const auto* refused = std::get_if<Refused>(&told))
      seen.push_back(refused->code);
    else
      seen.push_back("end");
  }
  void close() override {
    seen.push_back("closed");
  }
  void go_on() override {
    ++rooms;
  }
  std::vector<std::string> take() {
    return std::exchange(seen, {});
  }

  std::vector<std::string> seen;
  int rooms = 0;
};

class VisitorBookTest : public testing::Test {
protected:
  VisitorBookTest() {
    host.teller = &book;
  }
  static Turn turn(std::uint64_t number, std::string words) {
    return {number, {std::move(words)}};
  }
  void pass(Milliseconds time) {
    host.now += time;
    book.expire(host.now);
  }
  std::vector<std::string> calls() {
    return std::exchange(host.calls, {});
  }

  test::FakeHost<VisitorBook> host;
  VisitorBook book{{2, Milliseconds(100)}, host};
  Noting first;
  Noting second;
  Noting third;
};

TEST_F(VisitorBookTest, AnswersTurns) {
  const auto visitor = book.come(first, Hello());
  EXPECT_TRUE(book.take(visitor, {1, {"one", "and on"}}));
  EXPECT_TRUE(book.take(visitor, turn(2, "two")));
  EXPECT_THAT(first.seen,
              ElementsAre("welcome session-1 0", "0 Hello.", "1 echo: one",
                          "1 echo: and on", "done 1", "2 echo: two", "done 2"));
  EXPECT_EQ(first.rooms, 2);
  EXPECT_EQ(book.counters().turns, 2);
}

TEST_F(VisitorBookTest, KeepsWhatComesBeforeTheSession) {
  host.begins = false;
  const auto visitor = book.come(first, Hello());
  EXPECT_TRUE(book.take(visitor, turn(1, "early")));
  EXPECT_FALSE(book.is_answered(visitor));
  EXPECT_THAT(first.seen, IsEmpty());
  host.begin(visitor);
  EXPECT_THAT(first.seen, ElementsAre("welcome session-1 0", "1 echo: early",
                                      "done 1", "0 Hello."));
}

TEST_F(VisitorBookTest, TakesATurnOnce) {
  const auto visitor = book.come(first, Hello());
  book.take(visitor, turn(1, "one"));
  first.take();
  calls();
  EXPECT_TRUE(book.take(visitor, turn(1, "something else")));
  EXPECT_THAT(first.take(), ElementsAre("1 echo: one", "done 1"));
  EXPECT_THAT(calls(), IsEmpty());
}

TEST_F(VisitorBookTest, RefusesATurnThatIsNotNext) {
  const auto visitor = book.come(first, Hello());
  first.take();
  EXPECT_FALSE(book.take(visitor, turn(2, "two")));
  EXPECT_THAT(first.take(), ElementsAre("not-next"));
  EXPECT_TRUE(book.take(visitor, turn(1, "one")));
}

TEST_F(VisitorBookTest, RefusesTooManyOpenTurns) {
  const auto visitor = book.come(first, Hello());
  std::uint64_t number = 0;
  while (book.has_room(visitor))
    book.take(visitor, turn(++number, "wait"));
  EXPECT_EQ(number, max_open_turns);
  first.take();
  EXPECT_FALSE(book.take(visitor, turn(number + 1, "one more")));
  EXPECT_THAT(first.take(), ElementsAre("too-many-turns"));
  host.answer(visitor, 1);
  EXPECT_TRUE(book.take(visitor, turn(number + 1, "one more")));
}

// -- bounds -------------------------------------------------------------------

TEST_F(VisitorBookTest, RefusesWhomThereIsNoRoomFor) {
  book.come(first);
  book.come(second);
  EXPECT_EQ(book.come(third), 0);
  EXPECT_THAT(third.take(), ElementsAre("full"));
  EXPECT_EQ(book.counters().refused, 1);
  book.lose(1, first, host.now);
  EXPECT_NE(book.come(third), 0);
}

TEST_F(VisitorBookTest, ForgetsWhoGoes) {
  for (int i = 0; i < 100; ++i) {
    const auto visitor = book.come(first);
    EXPECT_EQ(book.size(), 1);
    book.lose(visitor, first, host.now);
    EXPECT_EQ(book.size(), 0);
  }
  EXPECT_EQ(book.next_expiry(), std::nullopt);
}

TEST_F(VisitorBookTest, KeepsOnlySoMuch) {
  const auto visitor = book.come(first, Hello());
  for (std::uint64_t i = 1; i <= 2 * max_kept; ++i)
    book.take(visitor, turn(i, "words"));
  first.take();
  EXPECT_FALSE(book.take(visitor, turn(1, "words")));
  EXPECT_THAT(first.take(), ElementsAre("too-old"));
  book.lose(visitor, first, host.now);
  book.come(second, {"session-1", 1, 2});
  EXPECT_EQ(second.seen.front(), "welcome session-1 128 again lost");
  EXPECT_EQ(second.seen.size(), 1 + max_kept);
}

// -- coming back --------------------------------------------------------------

TEST_F(VisitorBookTest, ASessionOutlivesItsConnection) {
  const auto visitor = book.come(first, Hello());
  book.take(visitor, turn(1, "one"));
  book.take(visitor, turn(2, "wait"));
  book.lose(visitor, first, host.now);
  host.say(visitor, "late");
  host.answer(visitor, 2);
  host.say(visitor, "by itself");
  // It has seen the greeting and the first answer, but not that it is done.
  EXPECT_EQ(book.come(second, {"session-1", 0, 2}), visitor);
  EXPECT_THAT(second.seen, ElementsAre("welcome session-1 2 again", "done 1",
                                       "2 late", "done 2", "0 by itself"));
  pass(Milliseconds(200)); // its time does not go on
  EXPECT_EQ(book.size(), 1);
  EXPECT_EQ(book.counters().resumed, 1);
}

TEST_F(VisitorBookTest, ASessionWaitsOnlySoLong) {
  const auto visitor = book.come(first, Hello());
  book.lose(visitor, first, host.now);
  pass(Milliseconds(99));
  EXPECT_EQ(book.size(), 1);
  pass(Milliseconds(1));
  EXPECT_EQ(book.size(), 0);
  EXPECT_THAT(calls(), testing::Contains("close 1"));
  EXPECT_EQ(book.come(second, {"session-1", 0, 0}), 0);
  EXPECT_THAT(second.take(), ElementsAre("unknown-session"));
}

TEST_F(VisitorBookTest, ANewConnectionTakesOver) {
  const auto visitor = book.come(first, Hello());
  first.take();
  EXPECT_EQ(book.come(second, {"session-1", 0, 1}), visitor);
  EXPECT_THAT(first.take(), ElementsAre("taken-over", "closed"));
  book.lose(visitor, first, host.now); // means nothing any more
  book.take(visitor, turn(1, "one"));
  EXPECT_THAT(second.take(), ElementsAre("welcome session-1 0 again",
                                         "1 echo: one", "done 1"));
}

// The connection is lost with the last words on their way.
TEST_F(VisitorBookTest, LastWordsCanBeFetched) {
  const auto visitor = book.come(first, Hello());
  book.take(visitor, turn(1, "end"));
  EXPECT_EQ(book.size(), 0);
  EXPECT_EQ(book.come(second, {"session-1", 0, 1}), visitor);
  EXPECT_THAT(second.take(),
              ElementsAre("welcome session-1 1 again", "1 echo: end", "done 1",
                          "end", "closed"));
  pass(Milliseconds(100));
  EXPECT_EQ(book.come(third, {"session-1", 0, 1}), 0);
  EXPECT_EQ(book.next_expiry(), std::nullopt);
}

// Who was away already when the session ended has the whole time from then on.
TEST_F(VisitorBookTest, LastWordsStayAsLongForWhoWasAway) {
  const auto visitor = book.come(first, Hello());
  book.lose(visitor, first, host.now);
  pass(Milliseconds(60));
  book.ended(visitor, "session-1", host.now);
  pass(Milliseconds(60));
  EXPECT_EQ(book.come(second, {"session-1", 0, 0}), visitor);
}

TEST_F(VisitorBookTest, LastWordsOfFewSessionsAreKept) {
  for (int i = 0; i < 5; ++i)
    book.take(book.come(first, Hello()), turn(1, "end"));
  book.expire(host.now);
  EXPECT_EQ(book.come(second, {"session-3", 0, 0}), 0);
  EXPECT_NE(book.come(second, {"session-4", 0, 0}), 0);
}

TEST_F(VisitorBookTest, WhoFinishesIsForgotten) {
  const auto visitor = book.come(first, Hello());
  book.finish(visitor);
  EXPECT_THAT(first.take(),
              ElementsAre("welcome session-1 0", "0 Hello.", "end", "closed"));
  EXPECT_EQ(book.come(second, {"session-1", 0, 0}), 0);
}

TEST_F(VisitorBookTest, WhoTypesDoesNotComeBack) {
  const auto visitor = book.come(first);
  book.lose(visitor, first, host.now);
  EXPECT_EQ(book.size(), 0);
  EXPECT_EQ(book.come(second, {"session-1", 0, 0}), 0);
}

// Of a run that was killed.
TEST_F(VisitorBookTest, BringsBackWhoWasLeft) {
  const auto visitor = book.bring_back(
      {"session-9", 7, 7, {{7, 12, "answer", "seven"}}}, host.now);
  EXPECT_EQ(book.size(), 1);
  EXPECT_EQ(book.come(first, {"session-9", 6, 11}), visitor);
  EXPECT_FALSE(book.take(visitor, turn(6, "again")));
  EXPECT_THAT(first.seen, ElementsAre("welcome session-9 7 again", "7 seven",
                                      "done 7", "too-old"));
  EXPECT_EQ(book.come(second, {"session-9", 5, 9}), visitor);
  EXPECT_THAT(second.seen[0], HasSubstr("lost"));
}

TEST_F(VisitorBookTest, BringsBackAnOpenTurn) {
  const auto visitor = book.bring_back(
      {"session-9", 3, 2, {{2, 5, "answer", "two"}, {3, 6, "chat", "well"}}},
      host.now);
  book.come(first, {"session-9", 2, 5});
  book.said(visitor, "session-9", {0, 7, "answer", "three"});
  book.done(visitor, "session-9", 3);
  EXPECT_THAT(first.seen, ElementsAre("welcome session-9 3 again", "3 well",
                                      "3 three", "done 3"));
}

TEST_F(VisitorBookTest, WhoWasLeftIsNotWaitedForForEver) {
  book.bring_back({"session-9", 1, 1, {}}, host.now);
  pass(Milliseconds(101));
  EXPECT_THAT(calls(), ElementsAre("close 1"));
  EXPECT_EQ(book.come(first, {"session-9", 1, 0}), 0);
}

} // namespace
} // namespace parlour::adapters::web
