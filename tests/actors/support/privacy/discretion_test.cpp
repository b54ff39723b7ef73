#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "actors/support/privacy/discretion.hpp"

namespace parlour::actors {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class DiscretionTest : public testing::Test {
protected:
  static Message message(const std::string& source, const std::string& text,
                         std::uint64_t number, const SessionId& session = "s") {
    Message made;
    made.source = source;
    made.command = "Says";
    made.params = {text};
    made.number = number;
    made.session = session;
    return made;
  }
  void see(const Message& seen, const std::string& way = "session") {
    discretion.pass(seen, way);
    Inspection inspection;
    inspection.kind = InspectionKind::message;
    inspection.session = seen.session;
    inspection.message = std::make_shared<const Message>(seen);
    inspection.way = way;
    discretion.show(std::move(inspection));
  }
  void log(const std::string& text) {
    discretion.show({InspectionKind::log, "s", "info", text});
  }
  // A turn of its own.
  void hear_private(const std::string& text) {
    discretion.pass(message("ASR", text, ++heard), "session");
    discretion.conceal_turn("s");
    discretion.settled("s", heard);
  }
  std::vector<std::string> shown() {
    return std::exchange(shown_, {});
  }

  std::uint64_t heard = 0;
  std::function<void()> also = [] {}; // who watches does that
  std::vector<std::string> shown_;
  Discretion discretion{
      [this](const Inspection& seen) {
        also();
        shown_.push_back(seen.message ? to_string(*seen.message) : seen.detail);
      },
      [](const Message& seen) { return seen.source == "ASR"; }};
};

TEST_F(DiscretionTest, ShowsAtOnceWhatNobodySaid) {
  log("one");
  EXPECT_THAT(shown(), ElementsAre("one"));
  discretion.conceal("s", {"1234"});
  log("pin 1234");
  EXPECT_THAT(shown(), ElementsAre("pin ***"));
}

TEST_F(DiscretionTest, ShowsWhatWasSaidWhenItIsUnderstood) {
  see(message("ASR", "hello", 1));
  log("greeting");
  EXPECT_THAT(shown(), IsEmpty());
  discretion.settled("s", 0); // of the turn before
  EXPECT_THAT(shown(), IsEmpty());
  discretion.settled("s", 1);
  EXPECT_THAT(shown(), ElementsAre("ASR.Says(hello)", "greeting"));
}

// The words opened the session, which says what was private in them.
TEST_F(DiscretionTest, ATurnMayBecomeAnothersThatIsToUnderstandIt) {
  see(message("ASR", "pin 4711", 7, "hall"));
  discretion.goes_on("hall", "s");
  log("begins");
  EXPECT_THAT(shown(), IsEmpty());
  discretion.conceal("s", {"4711"});
  discretion.settled("s", 7);
  EXPECT_THAT(shown(), ElementsAre("ASR.Says(***)", "begins"));
  EXPECT_TRUE(discretion.is_private("pin 4711"));
  discretion.goes_on("hall", "s"); // nothing was heard there
  log("goes on");
  EXPECT_THAT(shown(), ElementsAre("goes on"));
}

// It comes behind what the other has heard itself, and both are understood.
TEST_F(DiscretionTest, ALateTurnIsHeldWithThoseOfTheNextSession) {
  see(message("ASR", "hello", 2, "t"));
  see(message("ASR", "4711", 1));
  discretion.goes_on("s", "t");
  discretion.conceal_turn("t");
  discretion.settled("t", 1);
  EXPECT_THAT(shown(), IsEmpty());
  discretion.settled("t", 2);
  EXPECT_THAT(shown(), ElementsAre("ASR.Says(***)", "ASR.Says(***)"));
}

// Who looks when all is over has held nothing back.
TEST_F(DiscretionTest, MasksAPrivateTurnAfterwards) {
  discretion.pass(message("ASR", "one to three", 1), "session");
  discretion.conceal_turn("s");
  discretion.pass(message("ASR", "one two three four", 2), "session");
  discretion.settled("s", 2);
  EXPECT_EQ(discretion.masked_afterwards("heard: one to three"), "heard: ***");
  EXPECT_EQ(discretion.masked("heard: one to three"), "heard: one to three");
  discretion.pass(message("ASR", "good day", 3), "session");
  discretion.settled("s", 3);
  EXPECT_EQ(discretion.masked_afterwards("good day"), "good day");
}

TEST_F(DiscretionTest, MasksAllThatWasHeardOfAPrivateTurn) {
  see(message("ASR", "one to three", 1));
  see(message("ASR", "one two three four", 2));
  see(message("Script", "one two three four", 3), "-> NLU");
  discretion.conceal("s", {"1234"});
  log("is it one to three, or 1234?");
  discretion.settled("s", 2);
  EXPECT_THAT(shown(), ElementsAre("ASR.Says(***)", "ASR.Says(***)",
                                   "Script.Says(***)", "is it ***, or ***?"));
  EXPECT_TRUE(discretion.is_private("one to three"));
  see(message("ASR", "one to three", 4));
  discretion.settled("s", 4);
  EXPECT_THAT(shown(), ElementsAre("ASR.Says(one to three)"));
}

TEST_F(DiscretionTest, MasksWhatIsSaidWhileAPrivateSlotIsAskedFor) {
  see(message("ASR", "mumble", 1));
  discretion.conceal_turn("s");
  discretion.settled("s", 1);
  EXPECT_THAT(shown(), ElementsAre("ASR.Says(***)"));
}

// By relays, or from nobody's session: who knows what it means?
TEST_F(DiscretionTest, MasksWhatGoesElsewhere) {
  see(message("ASR", "1234", 1), "relay -> NLU");
  see(message("ASR", "1234", 2, ""), "every session");
  EXPECT_THAT(shown(), ElementsAre("ASR.Says(***)", "ASR.Says(***)"));
}

TEST_F(DiscretionTest, KnowsItWhenTheSessionIsOver) {
  discretion.conceal("s", {"1234"});
  see(message("ASR", "bye", 1));
  discretion.ended("s");
  EXPECT_THAT(shown(), ElementsAre("ASR.Says(bye)"));
  EXPECT_EQ(discretion.masked("1234"), "***");
}

// Whatever stands first in the alphabet.
TEST_F(DiscretionTest, ForgetsTheOldestWordsOfPrivateTurns) {
  hear_private("zero one");
  for (int i = 0; i < 1'000; ++i)
    hear_private("word " + std::to_string(i) + ".");
  hear_private("91234567, please");
  EXPECT_TRUE(discretion.is_private("91234567, please"));
  EXPECT_EQ(discretion.masked_afterwards("91234567, please"), "***");
  EXPECT_TRUE(discretion.is_private("word 999."));
  EXPECT_FALSE(discretion.is_private("zero one"));
}

TEST_F(DiscretionTest, HoldsNotWithoutBound) {
  see(message("ASR", "one two", 1));
  for (int i = 0; i < 10'000; ++i)
    log("one two");
  EXPECT_THAT(shown(), testing::Contains("***").Times(10'000));
  log("more");
  EXPECT_THAT(shown(), ElementsAre("more"));
}

TEST_F(DiscretionTest, ForgetsSessionsThatEndedLongAgo) {
  for (int i = 0; i <= 100; ++i) {
    const auto id = std::to_string(i);
    discretion.conceal(id, {"secret " + id + "."});
    discretion.ended(id);
  }
  EXPECT_FALSE(discretion.is_private("secret 0."));
  EXPECT_TRUE(discretion.is_private("secret 1."));
}

TEST_F(DiscretionTest, KnowsSoManySecretsOfASession) {
  discretion.conceal("s", {"zero"});
  for (int i = 0; i <= 1'000; ++i)
    discretion.conceal("s", {"secret " + std::to_string(i) + "."});
  EXPECT_FALSE(discretion.is_private("zero"));
  EXPECT_TRUE(discretion.is_private("secret 1000."));
}

// Or else a report could not be written while somebody watches, and whoever
// sends would wait for that.
TEST_F(DiscretionTest, CanBeAskedAndToldWhileItShows) {
  discretion.conceal("s", {"1234"});
  also = [this] {
    EXPECT_EQ(discretion.masked_afterwards("1234"), "***");
    EXPECT_TRUE(discretion.is_private("1234"));
    std::thread([this] {
      discretion.pass(message("ASR", "hello", 1), "session");
    }).join();
  };
  log("pin 1234");
  EXPECT_THAT(shown(), ElementsAre("pin ***"));
  discretion.settled("s", 1);
}

TEST(Discretion, WithoutAnythingPrivateShowsAllAsItIs) {
  std::vector<std::string> shown;
  Discretion open([&](const Inspection& seen) { shown.push_back(seen.detail); },
                  {});
  EXPECT_FALSE(open.hides());
  open.conceal("s", {"secret"});
  open.conceal_turn("s");
  open.show({InspectionKind::log, "s", "info", "a secret"});
  EXPECT_THAT(shown, ElementsAre("a secret"));
  EXPECT_EQ(open.masked("a secret"), "a secret");
  EXPECT_EQ(open.masked_afterwards("a secret"), "a secret");
  EXPECT_FALSE(open.is_private("secret"));
}

} // namespace
} // namespace parlour::actors
