#include "actors/routing/session_directory.hpp"
#include "tests/actors/bench.hpp"

namespace parlour::actors {
namespace {

TEST(SessionDirectory, FindsWhatIsThere) {
  Bench bench;
  SessionDirectory directory;
  auto ada = bench.session_probe("ada");
  auto ben = bench.session_probe("ben");
  directory.add("a", ada);
  const auto desk = bench.seat_probe();
  directory.add("b", ben, desk);
  EXPECT_EQ(directory.seat_of("b"), desk);
  EXPECT_FALSE(directory.seat_of("c"));
  EXPECT_EQ(directory.seats().size(), 2u);
  EXPECT_EQ(directory.find("a"), ada);
  EXPECT_THAT(directory.all(), ElementsAre(ada, ben));
  directory.remove("a");
  directory.remove("a");
  EXPECT_FALSE(directory.find("a"));
  EXPECT_EQ(directory.find("b"), ben);
  directory.clear();
  EXPECT_THAT(directory.all(), IsEmpty());
}

} // namespace
} // namespace parlour::actors
