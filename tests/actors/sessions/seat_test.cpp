#include <stdexcept>

#include "actors/sessions/seat.hpp"
#include "tests/actors/bench.hpp"

namespace parlour::actors {
namespace {

class SeatTest : public testing::Test {
protected:
  SeatTest() {
    bench.sessions.add("a", bench.session_probe("a"));
  }

  void speak(const seat_actor& seat, const std::string& session) {
    auto output = std::make_shared<dialogue::Output>();
    output->id = 7;
    output->text = "Hello.";
    bench.send(seat, say{session, output, bench.work()});
  }

  Bench bench;
  SeatParts parts{&bench.time, &bench.observer, &bench.sessions};
  std::vector<std::string> calls;
  SeatCalls noting{
      [this](const auto& session, const dialogue::Output& output) {
        calls.push_back(session + ": " + output.text);
      },
      [this](const auto& session) { calls.push_back(session + " over"); }};
};

TEST_F(SeatTest, ShowsWhatIsSaidAndThatItWasHeard) {
  auto actor = bench.spawn(seat, parts, noting);
  speak(actor, "a");
  bench.send(actor, session_over{"a", bench.work()});
  EXPECT_THAT(calls, ElementsAre("a: Hello.", "a over"));
  EXPECT_THAT(bench.seen, ElementsAre("a played 7"));
  EXPECT_TRUE(bench.time.work.none());
}

TEST_F(SeatTest, ShowsTheLastWordsOfASessionThatIsGone) {
  auto actor = bench.spawn(seat, parts, noting);
  speak(actor, "gone");
  EXPECT_THAT(calls, ElementsAre("gone: Hello."));
  EXPECT_THAT(bench.seen, IsEmpty());
}

TEST_F(SeatTest, HasBeenHeardWhereNobodyListens) {
  auto actor = bench.spawn(seat, parts, SeatCalls{});
  speak(actor, "a");
  bench.send(actor, session_over{"a", bench.work()});
  EXPECT_THAT(bench.seen, ElementsAre("a played 7"));
  EXPECT_TRUE(bench.time.work.none());
}

TEST_F(SeatTest, SurvivesWhatItsCallsThrow) {
  SeatCalls throwing{
      [](const auto&, const auto&) { throw std::runtime_error("no paper"); },
      [](const auto&) { throw std::runtime_error("no ink"); },
      [](const auto&) { throw std::runtime_error("no pen"); }};
  auto actor = bench.spawn(seat, parts, throwing);
  speak(actor, "a");
  bench.send(actor, session_over{"a", bench.work()});
  bench.send(actor, next_session{"b", bench.work()});
  speak(actor, "a");
  EXPECT_THAT(bench.seen, ElementsAre("a did not play 7", "a did not play 7"));
  EXPECT_THAT(bench.logs,
              ElementsAre(HasSubstr("no paper"), HasSubstr("no ink"),
                          HasSubstr("no pen"), HasSubstr("no paper")));
}

// The tool that it would call may be gone by then.
TEST_F(SeatTest, CallsNobodyOnceTheNodeIsLeftBehind) {
  noting.on_next = [this](const auto& session) {
    calls.push_back(session + " next");
  };
  auto actor = bench.spawn(seat, parts, noting);
  bench.send(actor, next_session{"a", bench.work()});
  EXPECT_THAT(calls, ElementsAre("a next"));
  bench.time.left_behind = true;
  speak(actor, "a");
  bench.send(actor, session_over{"a", bench.work()});
  bench.send(actor, next_session{"b", bench.work()});
  EXPECT_THAT(calls, ElementsAre("a next"));
}

TEST(ConfiguredName, IsThatOfTheSettings) {
  Bench bench;
  const auto desk = bench.seat_probe();
  const auto visitor = bench.seat_probe();
  const TextMap<seat_actor> seats = {{"desk", desk}, {"seat-1", visitor}};
  const std::vector<SeatSettings> configured = {{"hall"}, {"desk"}};
  EXPECT_EQ(configured_name(desk, seats, configured), "desk");
  EXPECT_EQ(configured_name(visitor, seats, configured), "");
  EXPECT_EQ(configured_name(desk, seats, {}), "");
}

} // namespace
} // namespace parlour::actors
