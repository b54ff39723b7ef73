#include <thread>

#include "actors/routing/message_bus.hpp"
#include "tests/actors/bench.hpp"

namespace parlour::actors {
namespace {

TEST(MessageBus, PublishFromAnyThread) {
  Bench bench;
  bench.bus.connect(bench.centre_probe());
  std::thread([&] {
    bench.bus.publish({event("Bell", "Rings"), event("Bell", "Stops")});
  }).join();
  EXPECT_FALSE(bench.time.work.none()); // waits in the queue
  bench.run();
  EXPECT_THAT(bench.seen, ElementsAre("Bell.Rings()", "Bell.Stops()"));
  EXPECT_TRUE(bench.time.work.none());
}

TEST(MessageBus, BringToComponentsWhatIsForThemAndTheRestToTheCentre) {
  Bench bench(R"(<routes><relay source="Bell" command="Rings" to="Ear"/>
                 </routes>)");
  bench.bus.connect(bench.centre_probe());
  bench.set_table({bench.target("Ear", {"ASR"})});
  auto asked = event("Bell", "Asks");
  asked.sinks = {"ASR", "Nobody"};
  bench.bus.publish({event("Bell", "Rings"), asked, event("Bell", "Off")});
  bench.run();
  EXPECT_THAT(
      bench.seen, // mailboxes of two
      testing::UnorderedElementsAre("Ear gets Bell.Rings() -> Ear",
                                    "Ear gets Bell.Asks() -> ASR, Nobody",
                                    "Bell.Rings()", "Bell.Off()"));
  EXPECT_THAT(bench.logs,
              ElementsAre("Bell.Asks() -> ASR, Nobody: nobody is there for "
                          "Nobody"));
  EXPECT_EQ(bench.bus.counters().messages(), 3u);
}

// However the routes lead from one that is down to the next.
TEST(MessageBus, AnswerOnceForComponentsThatAreDown) {
  Bench bench(R"(<routes><relay source="City" command="Failed" to="City"/>
                 </routes>)");
  bench.bus.connect(bench.centre_probe());
  const auto city = bench.target("City", {"Taxi"});
  city.mailbox->close("is down");
  bench.set_table({city});
  auto book = event("Bell", "Book");
  book.sinks = {"City"};
  book.correlation = 7;
  bench.bus.publish({book});
  bench.run();
  EXPECT_THAT(bench.seen, ElementsAre("City.Failed(City is down)"));
  EXPECT_EQ(bench.bus.counters().unhandled, 2u);
}

// It was there when the sender looked.
TEST(MessageBus, AnswerForWhomNobodyFillsAnyMore) {
  Bench bench;
  bench.bus.connect(bench.centre_probe());
  auto book = event("Bell", "Book");
  book.sinks = {"Taxi", "Robot"};
  bench.bus.publish({book}); // nobody waits for an answer
  bench.run();
  EXPECT_THAT(bench.seen, testing::IsEmpty());
  book.correlation = 7;
  bench.bus.publish({book});
  bench.run();
  EXPECT_THAT(bench.seen, ElementsAre("Taxi.Failed(nobody is there for it)"));
}

TEST(MessageBus, AnswersAtOnceForAMailboxThatIsClosed) {
  Bench bench;
  const auto target = bench.target("City", {"Taxi"});
  auto message = event("Script", "Book", {}, "s1");
  message.correlation = 7;
  auto give = [&] {
    return bench.bus.hand_over(target, {shared(message), bench.work()});
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
  EXPECT_EQ(bench.bus.counters().unhandled, 1u);
  message.correlation = 0;
  EXPECT_FALSE(give());
}

// Who watches may bring something in while it is shown something else.
TEST(MessageBus, BringInWhatTheCentreRoutes) {
  Bench bench;
  bench.bus.connect(bench.centre_probe());
  bench.bus.bring_in({event("Bell", "Rings")});
  bench.run();
  EXPECT_THAT(bench.seen, ElementsAre("outside: Bell.Rings()"));
  EXPECT_EQ(bench.bus.counters().messages(), 0u);
}

TEST(MessageBus, PublishToNobodyWhenTheNodeIsDown) {
  Bench bench;
  bench.bus.take_down();
  bench.bus.publish({event("Bell", "Rings")});
  EXPECT_TRUE(bench.time.work.none());
}

// Whoever still runs meanwhile: an interrupt ends the waiting for them.
TEST(MessageBus, CanBeAskedWhenTheNodeIsDown) {
  Bench bench;
  bench.bus.connect(bench.centre_probe());
  const auto ear = bench.target("Ear", {"ASR"});
  bench.set_table({ear});
  bench.bus.take_down();
  ASSERT_TRUE(bench.bus.table());
  EXPECT_EQ(bench.bus.table()->find("ASR", ""), nullptr);
  EXPECT_FALSE(bench.bus.is_heard(event("Ear", "Hears", {"hello"})));
  auto question = event("Bell", "Asks");
  question.sinks = {"ASR"};
  EXPECT_FALSE(bench.bus.ask(question, bench.work()));
  bench.bus.publish({question, event("Bell", "Rings")});
  bench.bus.bring_in({event("Bell", "Rings")});
  bench.bus.retire(bench.session_probe("a"), bench.work());
  bench.set_table({ear}); // the supervisor is late
  EXPECT_FALSE(bench.bus.ask(question, bench.work()));
  bench.run();
  EXPECT_THAT(bench.seen, ElementsAre());
  EXPECT_THAT(bench.logs, ElementsAre());
  EXPECT_TRUE(bench.time.work.none());
}

// For threads that send while it goes: a sanitizer sees it.
TEST(MessageBus, GoesDownWhileOthersSend) {
  Bench bench;
  bench.bus.connect(bench.centre_probe());
  std::atomic<bool> over = false;
  std::thread sender([&] {
    while (!over) {
      EXPECT_TRUE(bench.bus.table());
      bench.bus.is_heard(event("Ear", "Hears", {"hello"}));
    }
  });
  bench.bus.take_down();
  over = true;
  sender.join();
}

TEST(MessageBus, ShowWhatNobodyTookOrLogIt) {
  Bench bench;
  std::vector<Inspection> shown;
  bench.watch([&](const auto& seen) { shown.push_back(seen); });
  bench.bus.unhandled(event("Bell", "Rings", {3}, "s1"), "nobody is in");
  EXPECT_EQ(bench.bus.counters().unhandled, 1u);
  EXPECT_THAT(bench.logs, ElementsAre()); // once is enough
  ASSERT_EQ(shown.size(), 1u);
  EXPECT_EQ(shown[0].kind, InspectionKind::unhandled);
  EXPECT_EQ(shown[0].session, "s1");
  EXPECT_EQ(shown[0].subject, "Bell.Rings");
  bench.watch({});
  bench.bus.unhandled(event("Bell", "Rings", {3}, "s1"), "nobody is in");
  EXPECT_EQ(bench.bus.counters().unhandled, 2u);
  EXPECT_THAT(bench.logs,
              ElementsAre("Bell.Rings(3): nobody is in  (session s1)"));
}

// A voice says word for word how far it is.
TEST(MessageBus, ShowNothingOfWhatNobodyHasToTake) {
  Bench bench;
  bench.set_table({bench.target("Voice", {"TTS"})});
  bench.bus.unhandled(event("Voice", "Mark", {1, "hi", 0}), "nobody");
  bench.bus.unhandled(event("Speaker", "Started", {1}), "nobody");
  EXPECT_EQ(bench.bus.counters().unhandled, 0u);
  EXPECT_THAT(bench.logs, ElementsAre());
  auto order = event("Script", "Finished");
  order.sinks = {"TTS"};
  bench.bus.unhandled(order, "nobody");
  bench.bus.unhandled(event("Voice", "Failed", {"hoarse"}), "nobody");
  bench.bus.unhandled(event("Bell", "Mark"), "nobody");
  EXPECT_EQ(bench.bus.counters().unhandled, 3u);
}

} // namespace
} // namespace parlour::actors
