// Which private values the conversation reports to its port, and when.
#include <algorithm>

#include <gmock/gmock.h>

#include "script/dialogue/context/privacy.hpp"
#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

using testing::Contains;
using testing::Not;

WorldOptions not_open() {
  WorldOptions options;
  options.open = false;
  return options;
}

struct PrivateWorld : World {
  explicit PrivateWorld(const std::string& script) : World(script, not_open()) {
    open();
  }

  void conceal(const std::vector<std::string>& texts) override {
    secrets.insert(secrets.end(), texts.begin(), texts.end());
  }
  void conceal_turn() override {
    ++turns;
  }
  void settled(std::uint64_t) override {
    ++settlements;
  }

  Texts secrets;
  int turns = 0;
  int settlements = 0;
};

const char* const vault = R"(<topic name="Open">
    <slot name="Pin" type="Functional" private="true" question="Pin?">
      <cardinality type="number"/></slot>
    <slot name="Name" type="Functional" question="Name?"/>
  </topic>)";

TEST(Privacy, TellsSlotsAsTheyArePrintedAndSpoken) {
  PrivateWorld world(vault);
  world.say(inform("Open", {{"Pin", 4711}, {"Name", "Ann"}}));
  EXPECT_THAT(world.secrets, Contains("4711"));
  EXPECT_THAT(world.secrets, Contains("four seven one one"));
  EXPECT_THAT(world.secrets,
              Contains("four thousand seven hundred and eleven"));
  EXPECT_THAT(world.secrets, Not(Contains("Ann")));
}

// It is private whatever becomes of it.
TEST(Privacy, TellsWhatASlotRefuses) {
  PrivateWorld world(vault);
  world.say(inform("Open", {{"Pin", "my dog's name"}}));
  EXPECT_THAT(world.secrets, Contains("my dog's name"));
}

TEST(Privacy, TellsVariablesWhenTheyChange) {
  PrivateWorld world(R"(<var name="token" expr="'abc1'" private="true"/>
      <handler name="H"><messages><component><Bell><Rings>
        <set name="token" expr="['abc2', {k: 'abc3'}]"/>
        <post module="Bell" command="Ring" param="{token}"/>
      </Rings></Bell></component></messages></handler>)");
  world.components["Bell"] = {};
  EXPECT_THAT(world.secrets, Contains("abc1"));
  world.event("Bell", "Rings");
  EXPECT_THAT(world.secrets, Contains("abc2"));
  EXPECT_THAT(world.secrets, Contains("abc3"));
}

// Each of these changes a variable in another way: Interpreter::writes() counts
// all of them.
TEST(Privacy, TellsWhatChangesInPlace) {
  PrivateWorld world(
      R"(<var name="all" expr="[['a0'], {k: 'b0'}]" private="true"/>
      <var name="one" expr="'c0'" private="true"/>
      <handler name="H"><messages><component><Bell><Rings>
        <set name="all[0][0]" expr="'a1'"/><log param="."/>
        <set name="all[1].k" expr="'b1'"/><log param="."/>
        <append name="all[0]" expr="'a2'"/><log param="."/>
        <call function="insert"><var expr="all"/><var expr="0"/>
          <var expr="'d1'"/></call><log param="."/>
        <call function="change"><var expr="one"/></call><log param="."/>
      </Rings></Bell></component></messages></handler>
      <function name="change"><param name="it"/>
        <set name="it" expr="'c1'"/></function>)");
  world.event("Bell", "Rings");
  for (const auto* text : {"a0", "b0", "c0", "a1", "b1", "a2", "d1", "c1"})
    EXPECT_THAT(world.secrets, Contains(text));
}

// Each change of a long list would otherwise push all that is private out of
// what the port remembers, itself included.
TEST(Privacy, TellsOfAListWhatIsNew) {
  PrivateWorld world(R"(<var name="heard" expr="[]" private="true"/>
      <handler name="H"><messages><component><Bell><Rings>
        <append name="heard" expr="'first'"/><log param="."/>
        <append name="heard" expr="'second'"/><log param="."/>
      </Rings></Bell></component></messages></handler>)");
  world.event("Bell", "Rings");
  EXPECT_THAT(world.secrets, Contains("second"));
  EXPECT_EQ(std::ranges::count(world.secrets, "first"),
            std::ranges::count(world.secrets, "second"));
}

TEST(Privacy, HidesTurnsWhileAPrivateSlotIsAskedFor) {
  PrivateWorld world(vault);
  world.event("ASR", "RecognitionResult", {"hello", 1});
  EXPECT_EQ(world.turns, 0);
  world.say(inform("Open", {}));
  world.event("ASR", "RecognitionResult", {"mumble", 1});
  EXPECT_EQ(world.turns, 1);
}

TEST(Privacy, SettlesOnlyWhereSomethingIsPrivate) {
  PrivateWorld open(R"(<topic name="T"><slot name="S"/></topic>)");
  open.say(inform("T", {{"S", "x"}}));
  EXPECT_EQ(open.settlements, 0);
  EXPECT_THAT(open.secrets, testing::IsEmpty());
  PrivateWorld world(vault);
  EXPECT_GT(world.settlements, 0);
}

} // namespace
} // namespace parlour::dialogue
