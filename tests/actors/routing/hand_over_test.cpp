#include "actors/routing/hand_over.hpp"
#include "tests/actors/bench.hpp"

namespace parlour::actors {
namespace {

TEST(HandOver, AnswersAtOnceForAMailboxThatIsClosed) {
  Bench bench;
  const auto target = bench.target("City", {"Taxi"});
  auto message = event("Script", "Book", {}, "s1");
  message.correlation = 7;
  auto give = [&] {
    return hand_over(bench.services, target, {shared(message), bench.work()});
  };
  EXPECT_FALSE(give());
  bench.run();
  EXPECT_THAT(bench.seen, ElementsAre("City gets Script.Book()"));
  target.mailbox->close("is down");
  const auto answer = give();
  ASSERT_TRUE(answer);
  EXPECT_EQ(to_string(*answer), "City.Failed(City is down)");
  EXPECT_EQ(answer->session, "s1");
  EXPECT_EQ(answer->correlation, 7u);
  EXPECT_EQ(bench.services.counters->unhandled, 1u);
  message.correlation = 0;
  EXPECT_FALSE(give());
}

} // namespace
} // namespace parlour::actors
