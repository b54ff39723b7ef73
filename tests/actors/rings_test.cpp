// Messages that trigger each other without end: the limits stop them, and the
// log says so.
#include "tests/actors/node_fixture.hpp"

namespace parlour::actors {
namespace {

using testing::Le;
using testing::SizeIs;

// Whatever it is given it says again.
ComponentOrder parrot(const std::string& name, const std::string& role) {
  return component(name, role,
                   [](FunctionPlugin& self, const Message& message) {
                     self.fire_event(message.command, message.params);
                   });
}

const std::string begin = R"(<handler name="Begin"><messages><component>
    <ASR><RecognitionResult><post module="Device" command="Sound" param="1"/>
    <speak param="Begun."/></RecognitionResult></ASR>
  </component></messages></handler>)";

class RingsTest : public NodeFixture {
protected:
  void expect_an_end() {
    EXPECT_THAT(say({"begin"}), ElementsAre("Begun."));
    EXPECT_THAT(errors, ElementsAre(HasSubstr("goes in a ring")));
    EXPECT_THAT(ways_of("Sound"), SizeIs(Le(8'000)));
    EXPECT_THAT(say({"again"}), ElementsAre("Begun."));
  }
};

TEST_F(RingsTest, ARelayToItselfEnds) {
  options.components = {parrot("Drum", "Device")};
  start(begin + R"(<routes><relay source="Drum" command="Sound" to="Drum"/>
                   </routes>)");
  expect_an_end();
}

TEST_F(RingsTest, ARingOfRelaysThatGrowsEnds) {
  options.components = {parrot("Drum", "Device"), parrot("Horn", "Robot")};
  start(begin + R"(<routes>
      <relay source="Drum" command="*" to="Horn, Horn"/>
      <relay source="Horn" command="Sound" to="Drum"/></routes>)");
  expect_an_end();
}

TEST_F(RingsTest, AHandlerThatPostsWhatItIsAnsweredEnds) {
  options.components = {parrot("Drum", "Device")};
  start(begin + R"(<handler name="Again"><messages><component>
      <Drum><Sound><post module="Drum" command="Sound"/></Sound></Drum>
    </component></messages></handler>)");
  expect_an_end();
}

// A loop of a script ends by itself, whatever it asks for.
TEST_F(RingsTest, ALoopOfRequestsGoesOn) {
  int heard = 0;
  options.components = {component(
      "Drum", "Device", [&](FunctionPlugin& self, const Message& given) {
        ++heard;
        self.answer(given, "Sound", {});
      })};
  start(R"(<handler name="Begin"><messages><component>
      <ASR><RecognitionResult><for name="i" from="1" to="1500">
        <request module="Drum" command="Sound" return="answer"/>
      </for><speak param="Done."/></RecognitionResult></ASR>
    </component></messages></handler>)");
  EXPECT_THAT(say({"begin"}), ElementsAre("Done."));
  EXPECT_EQ(heard, 1'500);
  EXPECT_THAT(errors, IsEmpty());
}

// What takes its time is honest, however long it lasts.
TEST_F(RingsTest, ALongChainInTimeGoesOn) {
  int heard = 0;
  options.components = {component(
      "Drum", "Device", [&](FunctionPlugin& self, const Message& given) {
        ++heard;
        self.host().after(50ms, [&self, given] {
          self.answer(given, "Sound", given.params);
        });
      })};
  start(begin + R"(<handler name="Again"><messages><component>
      <Drum><Sound><post module="Drum" command="Sound"/></Sound></Drum>
    </component></messages></handler>)");
  say({"begin"});
  node->advance(50s);
  EXPECT_GE(heard, 990);
  EXPECT_THAT(errors, IsEmpty());
}

} // namespace
} // namespace parlour::actors
