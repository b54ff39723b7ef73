#include "actors/sessions/program_change.hpp"
#include "tests/actors/bench.hpp"
#include "tests/actors/node_fixture.hpp"

namespace parlour::actors {
namespace {

// For all sessions of one program the same object, so that it is made once.
TEST(ProgramChangeTest, FindsNamesOnceForEachProgram) {
  Bench bench;
  auto parts = std::make_shared<SessionParts>(
      SessionParts{bench.time, bench.bus, bench.observer, compile(echo)});
  const ProgramChange change(parts, ReloadMode::keep);
  const auto one = compile(echo);
  const auto other = compile("<var name='x' expr='1'/>");
  EXPECT_EQ(change.renames_from(one), change.renames_from(one));
  EXPECT_NE(change.renames_from(one), change.renames_from(other));
  EXPECT_EQ(&change.renames_from(other)->from(), other.get());
  EXPECT_EQ(change.renames_from(other)->to(), parts->program);
}

TEST(ReloadTallyTest, IsToldWhenTheLastHasAnswered) {
  std::vector<ReloadedSessions> told;
  ReloadTally tally{
      [&](const program_reloaded& what) { told.push_back(what.sessions); }, 4};
  tally.take({.lost = {"the state 'A'"}});
  tally.one_less();
  tally.take({.later = true, .lost = {"the state 'A'"}});
  tally.one_less();
  EXPECT_TRUE(told.empty());
  tally.take({.has_ended = true});
  tally.one_less();
  EXPECT_TRUE(told.empty());
  tally.one_less(); // one that ended before it answered
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0].gone_over, 1U);
  EXPECT_EQ(told[0].later, 1U);
  EXPECT_EQ(told[0].lost,
            (std::map<std::string, std::size_t>{{"the state 'A'", 2}}));
}

} // namespace
} // namespace parlour::actors
