#include <thread>

#include "actors/services.hpp"
#include "tests/actors/bench.hpp"

namespace parlour::actors {
namespace {

TEST(Services, PublishFromAnyThread) {
  Bench bench;
  bench.services.centre = bench.centre_probe();
  std::thread([&] {
    bench.services.publish({event("Bell", "Rings"), event("Bell", "Stops")});
  }).join();
  EXPECT_FALSE(bench.services.work.none()); // waits at the gate
  bench.run();
  EXPECT_THAT(bench.seen, ElementsAre("Bell.Rings()", "Bell.Stops()"));
  EXPECT_TRUE(bench.services.work.none());
}

TEST(Services, PublishToNobodyWhenTheHouseIsDown) {
  Bench bench;
  bench.services.publish({event("Bell", "Rings")});
  EXPECT_TRUE(bench.services.work.none());
}

TEST(Services, ShowWhatNobodyTookOrLogIt) {
  Bench bench;
  std::vector<Inspection> shown;
  bench.services.inspect = [&](const auto& seen) { shown.push_back(seen); };
  bench.services.unhandled(event("Bell", "Rings", {3}, "s1"), "nobody is in");
  EXPECT_EQ(bench.services.counters->unhandled, 1u);
  EXPECT_THAT(bench.logs, ElementsAre()); // once is enough
  ASSERT_EQ(shown.size(), 1u);
  EXPECT_EQ(shown[0].kind, InspectionKind::unhandled);
  EXPECT_EQ(shown[0].session, "s1");
  EXPECT_EQ(shown[0].subject, "Bell.Rings");
  bench.services.inspect = {};
  bench.services.unhandled(event("Bell", "Rings", {3}, "s1"), "nobody is in");
  EXPECT_EQ(bench.services.counters->unhandled, 2u);
  EXPECT_THAT(bench.logs, ElementsAre("Bell.Rings(3): nobody is in"));
}

TEST(Services, AreTappedForWhoeverWatches) {
  Bench bench;
  std::vector<Inspection> shown;
  bench.services.inspect = [&](const auto& seen) { shown.push_back(seen); };
  inspection_tap(bench.services)(event("Bell", "Rings"), "-> Ear");
  ASSERT_EQ(shown.size(), 1u);
  EXPECT_EQ(shown[0].kind, InspectionKind::message);
  EXPECT_EQ(shown[0].way, "-> Ear");
  EXPECT_EQ(shown[0].message->command, "Rings");
}

} // namespace
} // namespace parlour::actors
