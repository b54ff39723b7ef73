// SpokenTest: a small application that repeats what it hears, with and without
// a voice, and a recogniser that hears what a test tells it.
#pragma once

#include "tests/tools/parlour/application_fixture.hpp"
#include "tests/tools/parlour/voice_test/fakes.hpp"
#include "tools/parlour/conversation_test/conversation_file.hpp"

namespace parlour::tools {

class SpokenTest : public ApplicationTest {
protected:
  SpokenTest() {
    EXPECT_FALSE(typed.has_errors()) << findings(typed);
    EXPECT_FALSE(spoken.has_errors()) << findings(spoken);
    for (auto& component : spoken.composition.components) {
      const auto& plugin = component.factory.description.name;
      if (plugin == "SphinxASR")
        component.factory = test::told_asr(hears);
      else if (plugin == "EspeakTTS")
        component.factory = test::humming_tts();
    }
  }

  static Conversation conversation(const std::string& text) {
    auto parsed = parse_conversation(text, "x.txt");
    EXPECT_TRUE(parsed.errors.empty());
    return parsed.conversation;
  }

  static constexpr const char* seat = R"(<Plugins>
      <Plugin>FileMicrophone</Plugin><Plugin>AdaptiveVAD</Plugin>
      <Plugin>SpeechEndpointer</Plugin><Plugin>SphinxASR</Plugin>
      <Plugin>EspeakTTS</Plugin><Plugin>FileSpeaker</Plugin></Plugins>
    <component name="FileMicrophone" scope="seat">
      <option name="file" value="user.wav"/></component>
    <component name="AdaptiveVAD" scope="seat"/>
    <component name="SpeechEndpointer" scope="seat"/>
    <component name="FileSpeaker" scope="seat">
      <option name="file" value="robot.wav"/></component>)";
  static constexpr const char* script = R"(<handler name="Turn"><messages>
    <component><ASR><RecognitionResult>
      <speak param="You said {_LPARAM1}."/>
    </RecognitionResult></ASR></component></messages></handler>)";

  std::shared_ptr<std::deque<std::string>> hears =
      std::make_shared<std::deque<std::string>>();
  Application typed = load("", script);
  Application spoken =
      load(seat, std::string("<include href=\"parlour:voice\"/>") + script);
};

} // namespace parlour::tools
