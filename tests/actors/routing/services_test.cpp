#include <thread>

#include "actors/routing/services.hpp"
#include "tests/actors/bench.hpp"

namespace parlour::actors {
namespace {

TEST(Services, PublishFromAnyThread) {
  Bench bench;
  bench.services.centre = bench.centre_probe();
  std::thread([&] {
    bench.services.publish({event("Bell", "Rings"), event("Bell", "Stops")});
  }).join();
  EXPECT_FALSE(bench.services.time.work.none()); // waits at the gate
  bench.run();
  EXPECT_THAT(bench.seen, ElementsAre("Bell.Rings()", "Bell.Stops()"));
  EXPECT_TRUE(bench.services.time.work.none());
}

TEST(Services, BringToComponentsWhatIsForThemAndTheRestToTheCentre) {
  Bench bench(R"(<routes><relay source="Bell" command="Rings" to="Ear"/>
                 </routes>)");
  bench.services.centre = bench.centre_probe();
  bench.set_table({bench.target("Ear", {"ASR"})});
  auto asked = event("Bell", "Asks");
  asked.sinks = {"ASR", "Nobody"};
  bench.services.publish({event("Bell", "Rings"), asked, event("Bell", "Off")});
  bench.run();
  EXPECT_THAT(
      bench.seen, // mailboxes of two
      testing::UnorderedElementsAre("Ear gets Bell.Rings() -> Ear",
                                    "Ear gets Bell.Asks() -> ASR, Nobody",
                                    "Bell.Rings()", "Bell.Off()"));
  EXPECT_THAT(bench.logs,
              ElementsAre("Bell.Asks() -> ASR, Nobody: nobody is there for "
                          "Nobody"));
  EXPECT_EQ(bench.services.counters->messages(), 3u);
}

// However the routes lead from one that is down to the next.
TEST(Services, AnswerOnceForComponentsThatAreDown) {
  Bench bench(R"(<routes><relay source="City" command="Failed" to="City"/>
                 </routes>)");
  bench.services.centre = bench.centre_probe();
  const auto city = bench.target("City", {"Taxi"});
  city.mailbox->close("is down");
  bench.set_table({city});
  auto book = event("Bell", "Book");
  book.sinks = {"City"};
  book.correlation = 7;
  bench.services.publish({book});
  bench.run();
  EXPECT_THAT(bench.seen, ElementsAre("City.Failed(City is down)"));
  EXPECT_EQ(bench.services.counters->unhandled, 2u);
}

// Who watches may bring something in while it is shown something else.
TEST(Services, BringInWhatTheCentreRoutes) {
  Bench bench;
  bench.services.centre = bench.centre_probe();
  bench.services.bring_in({event("Bell", "Rings")});
  bench.run();
  EXPECT_THAT(bench.seen, ElementsAre("outside: Bell.Rings()"));
  EXPECT_EQ(bench.services.counters->messages(), 0u);
}

TEST(Services, PublishToNobodyWhenTheHouseIsDown) {
  Bench bench;
  bench.services.table.store(nullptr);
  bench.services.publish({event("Bell", "Rings")});
  EXPECT_TRUE(bench.services.time.work.none());
}

TEST(Services, ShowWhatNobodyTookOrLogIt) {
  Bench bench;
  std::vector<Inspection> shown;
  bench.watch([&](const auto& seen) { shown.push_back(seen); });
  bench.services.unhandled(event("Bell", "Rings", {3}, "s1"), "nobody is in");
  EXPECT_EQ(bench.services.counters->unhandled, 1u);
  EXPECT_THAT(bench.logs, ElementsAre()); // once is enough
  ASSERT_EQ(shown.size(), 1u);
  EXPECT_EQ(shown[0].kind, InspectionKind::unhandled);
  EXPECT_EQ(shown[0].session, "s1");
  EXPECT_EQ(shown[0].subject, "Bell.Rings");
  bench.watch({});
  bench.services.unhandled(event("Bell", "Rings", {3}, "s1"), "nobody is in");
  EXPECT_EQ(bench.services.counters->unhandled, 2u);
  EXPECT_THAT(bench.logs, ElementsAre("Bell.Rings(3): nobody is in"));
}

// A voice says word for word how far it is.
TEST(Services, ShowNothingOfWhatNobodyHasToTake) {
  Bench bench;
  bench.set_table({bench.target("Voice", {"TTS"})});
  bench.services.unhandled(event("Voice", "Mark", {1, "hi", 0}), "nobody");
  bench.services.unhandled(event("Speaker", "Started", {1}), "nobody");
  EXPECT_EQ(bench.services.counters->unhandled, 0u);
  EXPECT_THAT(bench.logs, ElementsAre());
  auto order = event("Script", "Finished");
  order.sinks = {"TTS"};
  bench.services.unhandled(order, "nobody");
  bench.services.unhandled(event("Voice", "Failed", {"hoarse"}), "nobody");
  bench.services.unhandled(event("Bell", "Mark"), "nobody");
  EXPECT_EQ(bench.services.counters->unhandled, 3u);
}

} // namespace
} // namespace parlour::actors
