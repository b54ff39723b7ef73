#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/audio/playout.hpp"
#include "tests/support/fake_plugin_host.hpp"

namespace parlour::adapters {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using Samples = std::vector<Sample>;

constexpr std::size_t a_ms = speech_rate / 1'000;

std::vector<std::string> texts(const std::vector<PlayoutEvent>& events) {
  std::vector<std::string> all;
  for (const auto& event : events) {
    auto said = event.to;
    said.source.clear();
    said.command = event.command;
    said.params = event.params;
    all.push_back(std::to_string(event.at / a_ms) + " " + event.to.session +
                  to_string(said));
  }
  return all;
}

class PlayoutTest : public testing::Test {
protected:
  // As many milliseconds of a sample.
  Expected<void> play(std::int64_t utterance, std::size_t ms, Sample sample = 9,
                      const SessionId& session = "a") {
    return playout.play(from(session), utterance,
                        pcm_value(Samples(ms * a_ms, sample)));
  }
  Expected<void> finish(std::int64_t utterance, const SessionId& session = "a",
                        Correlation correlation = 3) {
    return playout.finish(from(session, correlation), utterance);
  }
  static Message from(const SessionId& session, Correlation correlation = 3) {
    return test::message("Play", {}, session, correlation);
  }
  Samples pull(std::size_t ms) {
    Samples out(ms * a_ms, 77);
    sounding = playout.pull(out) / a_ms;
    return out;
  }
  std::vector<std::string> events() {
    return texts(playout.events(playout.pulled()));
  }

  Playout playout;
  std::size_t sounding = 0; // ms of what was pulled last
};

TEST_F(PlayoutTest, SilenceWhileThereIsNothing) {
  EXPECT_TRUE(playout.is_idle());
  EXPECT_EQ(pull(20), Samples(20 * a_ms, 0));
  EXPECT_EQ(sounding, 0u);
  EXPECT_THAT(events(), IsEmpty());
}

TEST_F(PlayoutTest, PlaysOneAfterTheOther) {
  ASSERT_TRUE(play(1, 50, 9));
  ASSERT_TRUE(play(2, 50, 5));
  ASSERT_TRUE(finish(1));
  ASSERT_TRUE(finish(2));
  auto expected = Samples(50 * a_ms, 9);
  expected.insert(expected.end(), 50 * a_ms, 5);
  expected.resize(120 * a_ms);
  EXPECT_EQ(pull(120), expected);
  EXPECT_EQ(sounding, 100u);
  EXPECT_THAT(events(), ElementsAre("0 a.Started(1)",
                                    "50 a.Finished(1, 50, false, unknown)",
                                    "50 a.Started(2)",
                                    "100 a.Finished(2, 50, false, unknown)"));
  EXPECT_TRUE(playout.is_idle());
}

TEST_F(PlayoutTest, EventsComeWhenTheyAreHeard) {
  ASSERT_TRUE(play(1, 50));
  ASSERT_TRUE(finish(1));
  pull(80);
  EXPECT_THAT(texts(playout.events(0)), ElementsAre("0 a.Started(1)"));
  EXPECT_THAT(playout.events(50 * a_ms - 1), IsEmpty());
  EXPECT_EQ(playout.events(50 * a_ms).size(), 1u);
  EXPECT_THAT(playout.events(80 * a_ms), IsEmpty());
}

TEST_F(PlayoutTest, BeginsOnceEnoughIsThere) {
  ASSERT_TRUE(play(1, 20));
  pull(10);
  EXPECT_EQ(sounding, 0u);
  ASSERT_TRUE(play(1, 20));
  pull(10);
  EXPECT_EQ(sounding, 10u);
}

TEST_F(PlayoutTest, BeginsWhenNoMoreCame) {
  ASSERT_TRUE(play(1, 20));
  pull(40);
  EXPECT_EQ(sounding, 0u);
  pull(10);
  EXPECT_EQ(sounding, 10u);
}

TEST_F(PlayoutTest, AShortOneBeginsWhenItIsFinished) {
  ASSERT_TRUE(play(1, 20));
  ASSERT_TRUE(finish(1));
  pull(10);
  EXPECT_EQ(sounding, 10u);
}

TEST_F(PlayoutTest, WaitsInSilenceForWhatComesLate) {
  ASSERT_TRUE(play(1, 50));
  pull(60);
  EXPECT_EQ(sounding, 50u);
  EXPECT_FALSE(playout.is_idle());
  pull(100);
  EXPECT_EQ(sounding, 0u);
  ASSERT_TRUE(play(1, 10));
  ASSERT_TRUE(finish(1));
  pull(20);
  EXPECT_EQ(sounding, 10u);
  EXPECT_THAT(events(), ElementsAre("0 a.Started(1)",
                                    "170 a.Finished(1, 60, false, unknown)"));
}

TEST_F(PlayoutTest, DoesNotWaitForEver) {
  ASSERT_TRUE(play(1, 50));
  ASSERT_TRUE(play(2, 50));
  ASSERT_TRUE(finish(2));
  for (int i = 0; i < 101; ++i)
    pull(100);
  EXPECT_THAT(events(), ElementsAre("0 a.Started(1)",
                                    "10100 a.Finished(1, 50, true, unknown)"));
  pull(60);
  EXPECT_THAT(events(), ElementsAre("10100 a.Started(2)",
                                    "10150 a.Finished(2, 50, false, unknown)"));
}

TEST_F(PlayoutTest, StopFadesAndSaysWhatWasSpoken) {
  for (const auto& [word, at] :
       {std::pair{"good", 0}, {"morning", 30}, {"to", 80}, {"you", 95}})
    ASSERT_TRUE(playout.mark(from("a"), 1, word, at));
  ASSERT_TRUE(play(1, 200, 10'000));
  ASSERT_TRUE(finish(1));
  pull(70);
  playout.stop("a", 1);
  const auto faded = pull(40);
  EXPECT_EQ(sounding, 20u);
  EXPECT_EQ(faded.front(), 10'000);
  EXPECT_LT(faded[20 * a_ms - 1], 50);
  EXPECT_EQ(faded[20 * a_ms], 0);
  EXPECT_THAT(events(),
              ElementsAre("0 a.Started(1)", "90 a.Finished(1, 90, true, "
                                            "good morning)"));
}

TEST_F(PlayoutTest, StopMeansOneSessionOnly) {
  for (const auto* session : {"a", "b"})
    for (const auto number : {1, 2})
      ASSERT_TRUE(play(number, 50, 9, session));
  playout.stop("b", std::nullopt);
  EXPECT_THAT(events(), ElementsAre("0 b.Finished(1, 0, true, unknown)",
                                    "0 b.Finished(2, 0, true, unknown)"));
  playout.stop("a", 2);
  EXPECT_THAT(events(), ElementsAre("0 a.Finished(2, 0, true, unknown)"));
  playout.stop("c", std::nullopt);
  EXPECT_THAT(events(), IsEmpty());
  EXPECT_FALSE(playout.is_idle());
}

TEST_F(PlayoutTest, TheNextOneFollowsTheFade) {
  ASSERT_TRUE(play(1, 100, 9));
  ASSERT_TRUE(play(2, 100, 5));
  pull(50);
  playout.stop("a", 1);
  const auto heard = pull(50);
  EXPECT_EQ(heard[20 * a_ms], 5);
  EXPECT_THAT(events(), ElementsAre("0 a.Started(1)",
                                    "70 a.Finished(1, 70, true, "
                                    "unknown)",
                                    "70 a.Started(2)"));
}

TEST_F(PlayoutTest, WhatWasStoppedIsNotPlayedLater) {
  ASSERT_TRUE(play(1, 100));
  playout.stop("a", 1);
  events();
  ASSERT_TRUE(play(1, 100));
  ASSERT_TRUE(playout.mark(from("a"), 1, "late", 0));
  EXPECT_TRUE(playout.is_idle());
  // Its Finish is answered if somebody waits for that.
  ASSERT_TRUE(finish(1));
  EXPECT_THAT(events(), ElementsAre("0 a.Finished(1, 0, true, unknown)"));
  // Now the number may be used again.
  ASSERT_TRUE(play(1, 100));
  EXPECT_FALSE(playout.is_idle());
}

TEST_F(PlayoutTest, ARoutedFinishOfWhatWasStoppedIsNotReportedTwice) {
  ASSERT_TRUE(play(1, 100));
  playout.stop("a", 1);
  events();
  ASSERT_TRUE(finish(1, "a", 0));
  EXPECT_THAT(events(), IsEmpty());
}

TEST_F(PlayoutTest, AnUtteranceWithoutSoundIsOverAtOnce) {
  ASSERT_TRUE(finish(8));
  EXPECT_THAT(events(), ElementsAre("0 a.Finished(8, 0, false, unknown)"));
  ASSERT_TRUE(playout.mark(from("a"), 9, "hush", 0));
  ASSERT_TRUE(finish(9));
  pull(1);
  EXPECT_THAT(events(), ElementsAre("0 a.Finished(9, 0, false, hush)"));
}

TEST_F(PlayoutTest, TheLastWordsAnswerTheMessageThatFinishes) {
  ASSERT_TRUE(playout.play(from("a", 11), 1, pcm_value(Samples(160))));
  ASSERT_TRUE(finish(1, "a", 12));
  pull(20);
  const auto told = playout.events(playout.pulled());
  ASSERT_EQ(told.size(), 2u);
  EXPECT_EQ(told[1].to.correlation, 12u);
  EXPECT_FALSE(finish(1, "b") && play(1, 10, 9, "b") && finish(1, "b") &&
               finish(1, "b"));
}

TEST_F(PlayoutTest, SaysWhatPlaysNow) {
  ASSERT_TRUE(play(1, 100));
  pull(20);
  const auto out = pull(20);
  const auto event = playout.playing(out);
  EXPECT_EQ(event.command, "Playing");
  EXPECT_EQ(event.to.session, "a");
  EXPECT_EQ(event.params[0], pcm_value(out));
  EXPECT_EQ(event.params[1], Value(20));
}

TEST_F(PlayoutTest, WhenTheDeviceIsLostEverythingIsOver) {
  ASSERT_TRUE(playout.mark(from("a"), 1, "one", 0));
  ASSERT_TRUE(playout.mark(from("a"), 1, "two", 50));
  ASSERT_TRUE(play(1, 100));
  ASSERT_TRUE(play(2, 100, 9, "b"));
  pull(60);
  EXPECT_THAT(texts(playout.abandon(40 * a_ms)),
              ElementsAre("0 a.Started(1)", "60 a.Finished(1, 40, true, )",
                          "60 b.Finished(2, 0, true, unknown)"));
  EXPECT_TRUE(playout.is_idle());
}

TEST_F(PlayoutTest, TooMuchIsRefused) {
  EXPECT_TRUE(play(1, 300'000));
  EXPECT_THAT(play(1, 1).error().message,
              HasSubstr("300 seconds of sound wait to be played"));
  pull(10);
  EXPECT_TRUE(play(1, 1));
  for (int i = 2; i <= 100; ++i)
    ASSERT_TRUE(play(i, 0)) << i;
  EXPECT_THAT(play(101, 0).error().message, HasSubstr("100 utterances"));
  for (int i = 0; i < 10'000; ++i)
    ASSERT_TRUE(playout.mark(from("a"), 1, "word", i));
  EXPECT_THAT(playout.mark(from("a"), 1, "word", 0).error().message,
              HasSubstr("too many words"));
  EXPECT_THAT(
      playout.mark(from("a"), 1, std::string(2'000, 'x'), 0).error().message,
      HasSubstr("too long"));
}

TEST_F(PlayoutTest, ManySmallPiecesAreRefused) {
  const auto audio = pcm_value(Samples(1));
  for (int i = 0; i < 50'000; ++i)
    ASSERT_TRUE(playout.play(from("a"), 1, audio));
  EXPECT_THAT(playout.play(from("a"), 1, audio).error().message,
              HasSubstr("too many pieces"));
}

TEST_F(PlayoutTest, WhatHasEndedIsForgottenInTime) {
  for (int i = 0; i < 1'000; ++i) {
    ASSERT_TRUE(play(i, 10));
    playout.stop("a", i);
  }
  events();
  ASSERT_TRUE(play(0, 10));
  EXPECT_FALSE(playout.is_idle());
}

TEST_F(PlayoutTest, RefusesWhatIsNoSpeech) {
  EXPECT_FALSE(playout.play(from("a"), 1, "hello"));
  EXPECT_FALSE(playout.play(from("a"), 1, pcm_value(Samples(8), {48'000, 2})));
  EXPECT_TRUE(playout.is_idle());
}

} // namespace
} // namespace parlour::adapters
