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
  EXPECT_EQ(directory.find("a"), ada);
  directory.remove("a");
  directory.remove("a");
  EXPECT_FALSE(directory.find("a"));
  EXPECT_EQ(directory.find("b"), ben);
  directory.clear();
  EXPECT_THAT(directory.all(), IsEmpty());
}

// However they were added: what is shown of them has this order.
TEST(SessionDirectory, ListsInTheOrderOfIds) {
  Bench bench;
  SessionDirectory directory;
  for (const auto* id : {"c", "a", "b"})
    directory.add(id, bench.session_probe(id), bench.seat_probe());
  std::string ids;
  for (const auto& entry : directory.all()) {
    ids += entry.id;
    EXPECT_EQ(entry.session, directory.find(entry.id));
    EXPECT_EQ(entry.seat, directory.seat_of(entry.id));
  }
  EXPECT_EQ(ids, "abc");
}

} // namespace
} // namespace parlour::actors
