// Conversations that are written, ended, and go on from their bytes. That they
// do so between all steps of every play and test of the dialogues is a run of
// this program of its own: CONTRIBUTING.md, PARLOUR_TEST_RESTORES.
#include <gtest/gtest.h>

#include "script/dialogue/engine/conversation.hpp"
#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

using namespace std::chrono_literals;

constexpr const char* taxi = R"(
  <var name="calls" expr="[]"/>
  <topic name="Taxi">
    <slot name="Where" type="Functional" question="Where to?"/>
    <slot name="When" type="Functional" question="When?" confirm="explicit">
      <cardinality type="time"/></slot>
    <filled>
      <confirm question="Shall I call it?"/>
      <request module="Telephone" command="Call" timeout="9s"><param expr="this.Where"/>
      </request>
      <speak param="It is on its way."/>
    </filled>
  </topic>
  <topic name="Shops" kind="enquiry">
    <slot name="Kind"/>
    <query source="facts:shops"><by slot="Kind" column="kind"/></query>
  </topic>
  <facts name="shops"><fact kind="food" name="Ann's"/></facts>
  <handler name="Bell"><messages><component><Bell><Rings>
    <timer name="knock" after="3s"><speak param="Knock."/></timer>
    <wait for="2s"/><speak param="A bell."/>
  </Rings></Bell></component></messages></handler>)";

WorldOptions options(bool restores) {
  WorldOptions options;
  options.restores = restores;
  return options;
}

// All that it says and sends in a conversation with something of everything.
Texts hold(World& world) {
  world.components["Telephone"] = {"Telephone"};
  world.say(inform("Taxi", {{"Where", "Sentosa"}}));
  world.event("Bell", "Rings");
  world.say(inform("Shops", {{"Kind", "food"}}));
  world.advance(4s);
  world.say(inform("Taxi", {{"When", "noon"}}));
  world.say("confirm");
  world.say("help");
  world.say("confirm");
  world.advance(1s);
  if (!world.messages.empty())
    world.event("Telephone", "Connected", {},
                world.messages.back().correlation);
  world.advance(30s);
  auto told = world.said();
  for (auto& text : world.posted())
    told.push_back(std::move(text));
  return told;
}

TEST(ConversationSaved, GoesOnAsIfNothingHadHappened) {
  World whole(taxi, options(false));
  World restored(taxi, options(true));
  const auto told = hold(whole);
  EXPECT_GT(told.size(), 6u);
  EXPECT_EQ(hold(restored), told);
  EXPECT_EQ(restored.conversation->save(), whole.conversation->save());
}

TEST(ConversationSaved, EqualInputsGiveEqualBytes) {
  World one(taxi), other(taxi);
  hold(one);
  hold(other);
  EXPECT_EQ(one.conversation->save(), other.conversation->save());
}

TEST(ConversationSaved, IsSmall) {
  World world(taxi);
  EXPECT_LE(world.conversation->save().size(), 300u);
  hold(world);
  EXPECT_LE(world.conversation->save().size(), 1000u);
}

std::string error_of(World& world, const std::string& bytes) {
  const auto restored = Conversation::restore(world.program, {}, world, bytes);
  return restored ? "" : restored.error().message;
}

TEST(ConversationSaved, AnotherProgramsBytesAreRefused) {
  World world(taxi);
  World other("<topic name='Bus'><slot name='Line'/></topic>");
  const auto error = error_of(other, world.conversation->save());
  EXPECT_NE(error.find("belongs to another program"), std::string::npos);
}

TEST(ConversationSaved, BytesThatEndTooEarlyAreRefused) {
  World world(taxi);
  world.say(inform("Taxi", {{"Where", "Sentosa"}}));
  const auto bytes = world.conversation->save();
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_NE(error_of(world, bytes.substr(0, size)), "") << size;
}

// Another one goes on from damaged bytes, where it takes them.
bool goes_on(World& world, const std::string& bytes) {
  auto restored = Conversation::restore(world.program, {}, world, bytes);
  if (!restored)
    return false;
  world.conversation = std::move(*restored);
  world.repeats = false;
  try {
    world.say(inform("Taxi", {{"Where", "Jurong"}, {"When", "3pm"}}));
    world.say("confirm");
    world.say("cancel");
    world.advance(20s);
    world.take(input::Closed());
    world.run();
  } catch (const std::runtime_error&) {
    // A world that does not come to rest is not what is asked here.
  }
  return true;
}

TEST(ConversationSaved, DamagedBytesAreRefusedOrGoOn) {
  World first(taxi);
  first.event("Bell", "Rings");
  first.say(inform("Taxi", {{"Where", "Sentosa"}, {"When", "noon"}}));
  const auto bytes = first.conversation->save();
  int taken = 0, refused = 0;
  World world(taxi);
  for (std::size_t at = 1; at < bytes.size(); ++at)
    for (const char change : {'\1', '\x80', '\x7f'}) {
      auto damaged = bytes;
      damaged[at] = static_cast<char>(damaged[at] ^ change);
      ++(goes_on(world, damaged) ? taken : refused);
    }
  EXPECT_GT(taken, 100);
  EXPECT_GT(refused, 100);
}

} // namespace
} // namespace parlour::dialogue
