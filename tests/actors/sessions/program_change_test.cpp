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

} // namespace
} // namespace parlour::actors
