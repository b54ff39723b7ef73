#include "actors/sessions/open_sessions.hpp"
#include "tests/actors/bench.hpp"

namespace parlour::actors {
namespace {

class OpenSessionsTest : public testing::Test {
protected:
  void open(const SessionId& id, const seat_actor& seat) {
    open_.add(id, bench.session_probe(id), seat);
  }
  std::string ids() const {
    std::string all;
    for (const auto& [actor, entry] : open_.all())
      all += entry.id;
    return all;
  }

  Bench bench;
  OpenSessions open_{bench.sessions};
};

TEST_F(OpenSessionsTest, AreFoundByIdActorAndSeat) {
  const auto desk = bench.seat_probe();
  open("a", desk);
  open("b", bench.seat_probe());
  auto* found = open_.find("a");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->seat, desk);
  EXPECT_EQ(bench.sessions.find("a"), found->session);
  EXPECT_EQ(open_.find(found->session.id()), found);
  EXPECT_EQ(open_.at(desk), found);
  EXPECT_FALSE(open_.find("c"));
  EXPECT_FALSE(open_.at(bench.seat_probe()));
}

TEST_F(OpenSessionsTest, AreFoundByNobodyWhenTheyAreRemoved) {
  const auto desk = bench.seat_probe();
  open("a", desk);
  const auto actor = open_.find("a")->session.id();
  const auto removed = open_.remove("a");
  ASSERT_TRUE(removed);
  EXPECT_EQ(removed->id, "a");
  EXPECT_EQ(removed->seat, desk);
  EXPECT_FALSE(open_.find("a"));
  EXPECT_FALSE(open_.find(actor));
  EXPECT_FALSE(open_.at(desk));
  EXPECT_FALSE(bench.sessions.find("a"));
  EXPECT_FALSE(open_.remove("a"));
  open("b", desk);
  EXPECT_EQ(open_.at(desk)->id, "b");
}

TEST_F(OpenSessionsTest, ComeInTheOrderInWhichTheyOpened) {
  for (const auto* id : {"c", "a", "d", "b"})
    open(id, bench.seat_probe());
  open_.remove("a");
  EXPECT_EQ(ids(), "cdb");
}

} // namespace
} // namespace parlour::actors
