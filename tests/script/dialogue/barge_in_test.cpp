// Barge-in: the user interrupts the robot (engine rule 3).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

using namespace std::chrono_literals;

constexpr const char* welcome = R"xml(
  <state name="Welcome"><Entrance>
    <speak param="Good morning, how can I help you?" interrupt="{X}"/>
  </Entrance></state>
  <topic name="Taxi"><slot name="Place" type="Functional" question="Where?"/>
  </topic>)xml";

class BargeIn : public testing::Test {
protected:
  void begin(const char* interrupt = "true") {
    std::string script = welcome;
    script.replace(script.find("{X}"), 3, interrupt);
    WorldOptions options;
    options.start = "Welcome";
    options.open = false;
    world_ = std::make_unique<World>(script, options);
    world_->components["Loudspeaker"] = {"Speaker"};
    world_->components["Ears"] = {"VAD"};
    world_->hold_outputs = true;
    world_->open();
    EXPECT_EQ(world_->said(), Texts{"Good morning, how can I help you?"});
  }
  void speaker_heard(const char* words) {
    world_->playing.clear();
    world_->event("Loudspeaker", "Finished", {1, 0, true, words});
    world_->hold_outputs = false;
  }

  std::unique_ptr<World> world_;
};

TEST_F(BargeIn, StopsTheSpeaker) {
  begin();
  world_->event("Ears", "SpeechStarted");
  EXPECT_EQ(world_->posted(), Texts{"Speaker.Stop()"});
}

TEST_F(BargeIn, NotWhereItMayNotBeInterrupted) {
  begin("false");
  world_->event("Ears", "SpeechStarted");
  EXPECT_EQ(world_->posted(), Texts{});
}

TEST_F(BargeIn, OnlyWhatWasHeardIsRepeated) {
  begin();
  world_->event("Ears", "SpeechStarted");
  speaker_heard("Good morning");
  world_->say("repeat");
  EXPECT_EQ(world_->said(), Texts{"Good morning"});
}

TEST_F(BargeIn, WhatNobodyHeardCannotBeRepeated) {
  begin();
  world_->event("Ears", "SpeechStarted");
  speaker_heard("");
  world_->say("repeat");
  EXPECT_EQ(world_->said(), Texts{"[repeat_nothing]"});
}

TEST_F(BargeIn, AfterANoiseAllIsSaidThatWasBrokenOff) {
  WorldOptions options;
  options.start = "Welcome";
  options.open = false;
  world_ = std::make_unique<World>(R"xml(
    <state name="Welcome"><Entrance>
      <speak param="The lift is on the left." interrupt="true"/>
      <speak param="The stairs are on the right." interrupt="true"/>
    </Entrance></state>)xml",
                                   options);
  world_->components["Loudspeaker"] = {"Speaker"};
  world_->components["Ears"] = {"VAD"};
  world_->hold_outputs = true;
  world_->open();
  const auto playing = world_->playing;
  ASSERT_EQ(playing.size(), 2u);
  world_->said();
  world_->playing.clear();
  world_->event("Ears", "SpeechStarted");
  world_->event(
      "Loudspeaker", "Finished",
      {static_cast<std::int64_t>(playing[0]), 0, true, "The lift is on"});
  world_->event("Loudspeaker", "Finished",
                {static_cast<std::int64_t>(playing[1]), 0, true, ""});
  world_->hold_outputs = false;
  world_->advance(2s);
  EXPECT_EQ(world_->said(),
            (Texts{"the left.", "The stairs are on the right."}));
}

TEST_F(BargeIn, ANoiseWithoutEndIsGivenUp) {
  begin();
  const auto noise = [&] {
    world_->hold_outputs = true;
    world_->event("Ears", "SpeechStarted");
    const auto id = static_cast<std::int64_t>(world_->playing.front());
    world_->playing.clear();
    world_->event("Loudspeaker", "Finished", {id, 0, true, "Good"});
    world_->advance(2s);
    return world_->said();
  };
  const Texts again{"Good morning, how can I help you?"};
  for (int time = 0; time < 3; ++time)
    EXPECT_EQ(noise(), again) << time;
  EXPECT_EQ(noise(), Texts{});
}

TEST_F(BargeIn, WhatIsHeardInBetweenEndsTheCounting) {
  begin();
  for (int time = 0; time < 5; ++time) {
    const auto id = static_cast<std::int64_t>(world_->playing.front());
    world_->playing.clear();
    world_->event("Ears", "SpeechStarted");
    world_->event("Loudspeaker", "Finished", {id, 0, true, "Good"});
    world_->advance(2s);
    EXPECT_EQ(world_->said(), Texts{"Good morning, how can I help you?"});
    const auto again = static_cast<std::int64_t>(world_->playing.front());
    world_->playing.clear();
    world_->event("Loudspeaker", "Finished", {again, 1, false, ""});
    world_->say("repeat");
    world_->said();
  }
}

TEST_F(BargeIn, ANoiseIsFollowedByTheSameOnceMore) {
  begin();
  world_->event("Ears", "SpeechStarted");
  speaker_heard("Good");
  world_->advance(1900ms);
  EXPECT_EQ(world_->said(), Texts{});
  world_->advance(100ms);
  EXPECT_EQ(world_->said(), Texts{"Good morning, how can I help you?"});
  world_->advance(20s);
  EXPECT_EQ(world_->said(), Texts{});
}

// Engine rule 3.7.
TEST_F(BargeIn, AnAnswerGoesOnWhereItStopped) {
  begin();
  world_->event("Ears", "SpeechStarted");
  speaker_heard("good morning how");
  world_->advance(2s);
  EXPECT_EQ(world_->said(), Texts{"can I help you?"});
}

TEST_F(BargeIn, WhatWasHeardToItsEndIsNotSaidAgain) {
  begin();
  world_->event("Ears", "SpeechStarted");
  speaker_heard("Good morning, how can I help you?");
  world_->advance(5s);
  EXPECT_EQ(world_->said(), Texts{});
}

// Engine rule 3.2.
TEST_F(BargeIn, ATurnLastsAsLongAsTheEndpointerSays) {
  begin();
  world_->components["Turns"] = {"Endpointer"};
  world_->event("Turns", "TurnStarted", {1'000});
  EXPECT_EQ(world_->posted(), Texts{"Speaker.Stop()"});
  speaker_heard("Good");
  world_->event("Keyboard", "Partial", {"er", 1});
  world_->advance(10s);
  EXPECT_EQ(world_->said(), Texts{});
  world_->event("Turns", "TurnEnded", {11'000});
  world_->advance(1900ms);
  EXPECT_EQ(world_->said(), Texts{});
  world_->advance(100ms);
  EXPECT_EQ(world_->said(), Texts{"Good morning, how can I help you?"});
}

// A quick recogniser has the words before the session has handled the end.
TEST_F(BargeIn, WordsThatArriveWithTheEndOfATurnEndTheSpeech) {
  begin();
  world_->components["Turns"] = {"Endpointer"};
  world_->event("Turns", "TurnStarted", {1'000});
  speaker_heard("Good morning, how can I help you?");
  Message end;
  end.source = "Turns";
  end.command = "TurnEnded";
  end.params = {2'000};
  end.session = "s1";
  world_->take(received(std::move(end)));
  world_->say(inform("Taxi", {}));
  EXPECT_EQ(world_->said(), Texts{"Where?"});
}

TEST_F(BargeIn, ATurnThatIsDroppedIsANoise) {
  begin();
  world_->components["Turns"] = {"Endpointer"};
  world_->event("Turns", "TurnStarted", {1'000});
  speaker_heard("Good");
  world_->event("Turns", "TurnDropped", {2'000});
  EXPECT_EQ(world_->said(), Texts{"Good morning, how can I help you?"});
}

TEST_F(BargeIn, WhatTheRecogniserRejectsIsANoise) {
  begin();
  world_->event("Ears", "SpeechStarted");
  speaker_heard("Good");
  world_->event("Keyboard", "Rejected", {"noise"});
  EXPECT_EQ(world_->said(), Texts{"Good morning, how can I help you?"});
}

TEST_F(BargeIn, WhoBreaksInIsAnswered) {
  begin();
  world_->event("Ears", "SpeechStarted");
  speaker_heard("Good");
  world_->say(inform("Taxi", {}));
  EXPECT_EQ(world_->said(), Texts{"Where?"});
  world_->advance(5s);
  EXPECT_EQ(world_->said(), Texts{});
}

constexpr const char* asking_script = R"xml(
  <topic name="Taxi" initiative="system">
    <slot name="Place" type="Functional" question="Where?"/></topic>)xml";

// What is said and recognised by nobody is not understood (engine rule 3.2).
class Unclear : public testing::Test {
protected:
  static void rejects(World& world) {
    world.event("Ears", "SpeechStarted");
    world.event("Keyboard", "Rejected", {"no words"});
  }
  static void listens(World& world) {
    world.components["Ears"] = {"VAD"};
    world.said();
  }
};

TEST_F(Unclear, SpeechIsAskedForAgain) {
  World world(asking_script);
  listens(world);
  rejects(world);
  EXPECT_THAT(world.said(), testing::ElementsAre(testing::HasSubstr("Where?")));
}

TEST_F(Unclear, SpeechIsApologisedFor) {
  World world(R"xml(<state name="Start"/>)xml");
  listens(world);
  rejects(world);
  EXPECT_EQ(world.said().size(), 1u);
}

TEST_F(Unclear, SpeechMayBeHandled) {
  World world(R"xml(<handler name="H"><messages><component><ASR><Rejected>
    <speak param="Pardon?"/></Rejected></ASR></component></messages></handler>)xml");
  listens(world);
  rejects(world);
  EXPECT_EQ(world.said(), Texts{"Pardon?"});
}

TEST_F(Unclear, NothingIsWithoutSpeech) {
  World world(asking_script);
  listens(world);
  world.event("Keyboard", "Rejected", {"no words"});
  EXPECT_EQ(world.said(), Texts{});
  world.event("Ears", "SpeechStarted");
  world.advance(3s);
  world.said();
  world.event("Keyboard", "Rejected", {"no words"});
  EXPECT_EQ(world.said(), Texts{});
}

// What a loudspeaker plays is not over when it was shown (engine rule 3.8).
class VoicedOutput : public testing::Test {
protected:
  VoicedOutput() {
    std::string script = welcome;
    script.replace(script.find("{X}"), 3, "true");
    WorldOptions options;
    options.start = "Welcome";
    options.open = false;
    world = std::make_unique<World>(script, options);
    world->components["Loudspeaker"] = {"Speaker"};
    world->components["Voice"] = {"TTS"};
    world->components["Ears"] = {"VAD"};
    world->open();
    world->said();
    world->posted();
  }

  std::unique_ptr<World> world;
};

TEST_F(VoicedOutput, IsPlayedUntilTheSpeakerSaysSo) {
  world->event("Ears", "SpeechStarted");
  EXPECT_EQ(world->posted(), (Texts{"TTS.Stop()", "Speaker.Stop()"}));
  world->event("Loudspeaker", "Finished", {1, 900, true, "Good morning, how"});
  world->advance(2s);
  EXPECT_EQ(world->said(), Texts{"can I help you?"});
}

TEST_F(VoicedOutput, CannotBeInterruptedOnceItIsHeard) {
  world->event("Loudspeaker", "Finished", {1, 2'000, false, "all of it"});
  world->event("Ears", "SpeechStarted");
  EXPECT_EQ(world->posted(), Texts{});
}

TEST_F(VoicedOutput, IsOverWhereTheVoiceFails) {
  world->event("Voice", "Failed", {"no such voice"});
  world->event("Ears", "SpeechStarted");
  EXPECT_EQ(world->posted(), Texts{});
}

constexpr const char* booking = R"xml(
  <topic name="Room"><slot name="Nights" type="Functional" question="How many?"
    confirm="never"/>
    <filled><confirm question="Shall I really book it now?"/></filled>
    <completed><speak param="Booked."/></completed></topic>)xml";

class BargeInOnAConfirm : public testing::Test {
protected:
  BargeInOnAConfirm() : world(booking) {
    world.components["Loudspeaker"] = {"Speaker"};
    world.components["Ears"] = {"VAD"};
    world.hold_outputs = true;
    world.say(inform("Room", {{"Nights", 2}}));
    EXPECT_EQ(world.said(), Texts{question});
    world.event("Ears", "SpeechStarted");
  }
  void heard(const char* words) {
    const auto id = static_cast<std::int64_t>(world.playing.front());
    world.playing.clear();
    world.event("Loudspeaker", "Finished", {id, 0, true, words});
    world.hold_outputs = false;
  }

  const char* question = "Shall I really book it now?";
  World world;
};

TEST_F(BargeInOnAConfirm, CountsWhereHalfOfItWasHeard) {
  heard("Shall I really");
  world.say("confirm");
  EXPECT_EQ(world.said(), Texts{"Booked."});
}

TEST_F(BargeInOnAConfirm, IsAskedAgainWhereLessWasHeard) {
  heard("Shall I");
  world.say("confirm");
  EXPECT_EQ(world.said(), Texts{question});
  world.say("confirm");
  EXPECT_EQ(world.said(), Texts{"Booked."});
}

TEST_F(BargeInOnAConfirm, ANoiseHasItSaidAgainOnce) {
  heard("Shall");
  world.advance(7s);
  EXPECT_EQ(world.said(), Texts{question});
  world.say("confirm");
  EXPECT_EQ(world.said(), Texts{"Booked."});
}

} // namespace
} // namespace parlour::dialogue
