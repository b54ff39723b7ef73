#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/endpointer/key_endpointer.hpp"
#include "adapters/endpointer/speech_endpointer.hpp"
#include "adapters/nlg/phrase_nlg.hpp"
#include "adapters/nlu/understand/grammar_nlu.hpp"
#include "adapters/push_to_talk/key_push_to_talk.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tools/parlour/application/voice.hpp"

namespace parlour::tools {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class Silent : public IPlugin {
protected:
  void on_message(const Message&) override {}
};

PluginFactory plugin(const std::string& name, const std::string& role,
                     const std::string& option = "") {
  PluginDescription description{name, {role}, "does nothing"};
  if (!option.empty())
    description.options = {{option, "", "which one"}};
  return {description, [] { return std::make_unique<Silent>(); }};
}

class VoiceTest : public testing::Test {
protected:
  VoiceTest() {
    folder.write("own.xml", "<dialogue><state name=\"A\"/></dialogue>");
    settings("<Scripts><Script>own.xml</Script></Scripts>");
  }
  void settings(const std::string& inside) {
    folder.write("settings.xml",
                 "<settings name=\"own\">\n" + inside + "\n</settings>\n");
  }
  std::filesystem::path path() const {
    return std::filesystem::canonical(folder.path());
  }
  Expected<Application> load(const VoiceWishes& wishes = {}) {
    const auto plugins = std::make_shared<Catalogue>(
        std::vector<std::filesystem::path>(), built_in);
    auto sources = add_voice(path(), platform, *plugins, wishes);
    if (!sources)
      return tl::make_unexpected(sources.error());
    libraries = sources->libraries;
    return load_application(path(), platform, Scrutiny::compile, plugins,
                            sources->sources());
  }
  static std::vector<std::string> names(const Application& application) {
    std::vector<std::string> names;
    for (const auto& component : application.composition.components)
      names.push_back(component.name);
    return names;
  }

  const std::string platform = test::source_path("config/platform");
  test::TemporaryFolder folder;
  std::vector<PluginFactory> built_in = {
      adapters::grammar_nlu_factory(),
      adapters::phrase_nlg_factory(),
      adapters::speech_endpointer_factory(),
      adapters::key_endpointer_factory(),
      adapters::key_push_to_talk_factory(),
      plugin("AlsaMicrophone", "Microphone", "device"),
      plugin("AlsaSpeaker", "Speaker", "device"),
      plugin("FileMicrophone", "Microphone", "file"),
      plugin("FileSpeaker", "Speaker", "file"),
      plugin("AdaptiveVAD", "VAD"),
      plugin("SphinxASR", "ASR"),
      plugin("EspeakTTS", "TTS"),
      plugin("OwnTTS", "TTS")};
  std::vector<std::string> libraries;
};

TEST_F(VoiceTest, FillsEveryRoleOfTheChain) {
  const auto application = load();
  ASSERT_TRUE(application);
  EXPECT_THAT(application->findings, IsEmpty());
  EXPECT_THAT(names(*application),
              ElementsAre("AlsaMicrophone", "AdaptiveVAD", "SpeechEndpointer",
                          "SphinxASR", "EspeakTTS", "AlsaSpeaker"));
  EXPECT_THAT(libraries, ElementsAre("voice"));
  ASSERT_TRUE(application->program);
  EXPECT_FALSE(application->program->routes.empty());
  for (const auto& component : application->composition.components)
    EXPECT_EQ(component.policy.scope.kind == Scope::Kind::seat,
              component.name != "SphinxASR" && component.name != "EspeakTTS")
        << component.name;
}

TEST_F(VoiceTest, LeavesWhatTheSettingsChose) {
  settings("<Plugins><Plugin>OwnTTS</Plugin></Plugins>"
           "<Scripts><Script>own.xml</Script></Scripts>");
  const auto application = load();
  ASSERT_TRUE(application);
  EXPECT_THAT(names(*application), Contains("OwnTTS"));
  EXPECT_THAT(names(*application), Not(Contains("EspeakTTS")));
}

TEST_F(VoiceTest, TakesTheRecogniserThatIsAskedFor) {
  built_in.push_back(plugin("OwnASR", "ASR"));
  settings("<Plugins><Plugin>SphinxASR</Plugin></Plugins>"
           "<Scripts><Script>own.xml</Script></Scripts>");
  VoiceWishes wishes;
  wishes.recogniser = "OwnASR";
  const auto application = load(wishes);
  ASSERT_TRUE(application);
  EXPECT_THAT(names(*application), Contains("OwnASR"));
  EXPECT_THAT(names(*application), Not(Contains("SphinxASR")));
}

TEST_F(VoiceTest, CleansTheAudioWhereItCan) {
  built_in.push_back(plugin("WebRtcEnhancement", "Enhancement"));
  const auto application = load();
  ASSERT_TRUE(application);
  EXPECT_THAT(application->findings, IsEmpty());
  EXPECT_THAT(libraries, ElementsAre("voice-enhanced"));
}

TEST_F(VoiceTest, SleepsUntilAWordIsSaid) {
  built_in.push_back(plugin("SphinxKeywords", "KeywordSpotter", "keywords"));
  EXPECT_EQ(load()->composition.components.size(), 6u);
  const auto application = load({"", "", "", "", "hey house"});
  ASSERT_TRUE(application);
  EXPECT_THAT(application->findings, IsEmpty());
  EXPECT_THAT(libraries, ElementsAre("voice-wake"));
  auto option = [&](const std::string& component, const std::string& name) {
    return std::ranges::find(application->composition.components, component,
                             &ChosenComponent::name)
        ->options.at(name);
  };
  EXPECT_EQ(option("SphinxKeywords", "keywords"), "hey house");
  EXPECT_EQ(option("SpeechEndpointer", "sleeps-after"), "10s");
}

TEST_F(VoiceTest, SleepsWithASpotterOfTheSettings) {
  built_in.push_back(plugin("OwnSpotter", "KeywordSpotter", "keywords"));
  built_in.push_back(plugin("WebRtcEnhancement", "Enhancement"));
  settings("<Plugins><Plugin>OwnSpotter</Plugin>"
           "<Plugin>SpeechEndpointer</Plugin></Plugins>"
           "<component name=\"SpeechEndpointer\" scope=\"seat\">"
           "<option name=\"sleeps-after\" value=\"1m\"/></component>"
           "<Scripts><Script>own.xml</Script></Scripts>");
  const auto application = load();
  ASSERT_TRUE(application);
  EXPECT_THAT(application->findings, IsEmpty());
  EXPECT_THAT(libraries, ElementsAre("voice-wake-enhanced"));
  const auto other = load({"", "", "", "", "hey house"});
  ASSERT_TRUE(other);
  EXPECT_EQ(std::ranges::find(other->composition.components, "OwnSpotter",
                              &ChosenComponent::name)
                ->options.at("keywords"),
            "hey house");
}

TEST_F(VoiceTest, HasAnEndpointerOfTheSettingsSleep) {
  built_in.push_back(plugin("SphinxKeywords", "KeywordSpotter", "keywords"));
  auto sleeps_after = [&](const std::string& option) {
    settings("<Plugins><Plugin>SpeechEndpointer</Plugin></Plugins>"
             "<component name=\"SpeechEndpointer\" scope=\"seat\">" +
             option +
             "</component>"
             "<Scripts><Script>own.xml</Script></Scripts>");
    const auto application = load({"", "", "", "", "hey house"});
    EXPECT_TRUE(application);
    return std::ranges::find(application->composition.components,
                             "SpeechEndpointer", &ChosenComponent::name)
        ->options.at("sleeps-after");
  };
  EXPECT_EQ(sleeps_after(""), "10s");
  EXPECT_EQ(sleeps_after("<option name=\"sleeps-after\" value=\"1m\"/>"), "1m");
}

TEST_F(VoiceTest, TakesFilesInThePlaceOfDevices) {
  auto application = load({"heard.wav", "plughw:\"1&2\""});
  ASSERT_TRUE(application);
  const auto& components = application->composition.components;
  const auto microphone =
      std::ranges::find(components, "FileMicrophone", &ChosenComponent::name);
  ASSERT_NE(microphone, components.end());
  EXPECT_EQ(microphone->policy.scope.kind, Scope::Kind::seat);
  use_files(application->composition, {"heard.wav", ""}, "/there");
  EXPECT_THAT(microphone->factory.description.sentence,
              HasSubstr("file")); // no longer the one that does nothing
  const auto speaker =
      std::ranges::find(components, "AlsaSpeaker", &ChosenComponent::name);
  ASSERT_NE(speaker, components.end());
  EXPECT_EQ(speaker->options.at("device"), "plughw:\"1&2\"");
}

// A run talks at the first seat, whatever the settings have elsewhere.
TEST_F(VoiceTest, IsAtTheFirstSeatOfTheSettings) {
  settings("<Plugins><Plugin>AlsaMicrophone</Plugin></Plugins>"
           "<Scripts><Script>own.xml</Script></Scripts>"
           "<seat name=\"desk\"/>"
           "<seat name=\"hall\" Microphone=\"AlsaMicrophone\"/>");
  const auto seat_of = [&](const char* name, const VoiceWishes& wishes) {
    const auto application = load(wishes);
    EXPECT_TRUE(application && application->program);
    const auto& components = application->composition.components;
    return std::ranges::find(components, name, &ChosenComponent::name)
        ->policy.seat;
  };
  EXPECT_EQ(seat_of("AlsaMicrophone", {}), "hall");
  EXPECT_EQ(seat_of("AlsaSpeaker", {}), "desk");
  EXPECT_EQ(seat_of("AlsaMicrophone", {"hw:1", ""}), "desk");
}

// But for what the command line says.
TEST_F(VoiceTest, KeepsTheOptionsOfItsPlugins) {
  settings("<Plugins><Plugin>FileMicrophone</Plugin></Plugins>"
           "<component name=\"FileMicrophone\" scope=\"seat\">"
           "<option name=\"file\" value=\"own.wav\"/></component>"
           "<component name=\"AlsaSpeaker\" scope=\"seat\">"
           "<option name=\"device\" value=\"hw:0\"/></component>"
           "<Scripts><Script>own.xml</Script></Scripts>");
  const auto application = load({"heard.wav", "hw:1"});
  ASSERT_TRUE(application);
  const auto option = [&](const char* component, const char* name) {
    return std::ranges::find(application->composition.components, component,
                             &ChosenComponent::name)
        ->options.at(name);
  };
  EXPECT_EQ(option("FileMicrophone", "file"), "own.wav");
  EXPECT_EQ(option("AlsaSpeaker", "device"), "hw:1");
}

TEST_F(VoiceTest, LetsAKeyBeginTurns) {
  settings("<Plugins><Plugin>SpeechEndpointer</Plugin></Plugins>"
           "<Scripts><Script>own.xml</Script></Scripts>");
  VoiceWishes wishes;
  wishes.push_to_talk = "/dev/input/event3";
  wishes.talk_key = "f5";
  const auto application = load(wishes);
  ASSERT_TRUE(application);
  EXPECT_THAT(application->findings, IsEmpty());
  EXPECT_THAT(names(*application), AllOf(Contains("KeyEndpointer"),
                                         Not(Contains("SpeechEndpointer"))));
  EXPECT_THAT(libraries, ElementsAre("voice", "push-to-talk"));
  const auto& components = application->composition.components;
  const auto key =
      std::ranges::find(components, "KeyPushToTalk", &ChosenComponent::name);
  ASSERT_NE(key, components.end());
  EXPECT_EQ(key->options.at("device"), "/dev/input/event3");
  EXPECT_EQ(key->options.at("key"), "f5");
  EXPECT_EQ(key->policy.scope.kind, Scope::Kind::seat);
}

TEST_F(VoiceTest, TheTerminalHasAKey) {
  VoiceWishes wishes;
  wishes.push_to_talk = terminal_key;
  const auto application = load(wishes);
  ASSERT_TRUE(application);
  const auto& components = application->composition.components;
  const auto key =
      std::ranges::find(components, "KeyPushToTalk", &ChosenComponent::name);
  ASSERT_NE(key, components.end());
  EXPECT_THAT(key->options, IsEmpty());
}

TEST_F(VoiceTest, ReadsSettingsWithoutContent) {
  folder.write("settings.xml", "<settings name=\"own\"/>");
  const auto application = load();
  ASSERT_TRUE(application);
  EXPECT_THAT(names(*application), Contains("SphinxASR"));
}

TEST_F(VoiceTest, SaysWhichRoleNobodyCanFill) {
  std::erase_if(built_in, [](const auto& one) {
    return one.description.name == "SphinxASR";
  });
  const auto application = load();
  ASSERT_FALSE(application);
  EXPECT_THAT(application.error().message, HasSubstr("role ASR"));
  EXPECT_THAT(load({"", "", "", "", "hey"}).error().message,
              HasSubstr("role KeywordSpotter"));
}

// What the command line says wins over the settings.
TEST_F(VoiceTest, ADeviceTakesThePlaceOfAllOfItsRole) {
  settings("<Plugins><Plugin>AlsaMicrophone</Plugin>"
           "<Plugin>FileMicrophone</Plugin></Plugins>"
           "<component name=\"AlsaMicrophone\">"
           "<option name=\"device\" value=\"hw:0\"/></component>"
           "<Scripts><Script>own.xml</Script></Scripts>");
  const auto application = load({"plughw:1", ""});
  ASSERT_TRUE(application);
  EXPECT_THAT(application->findings, IsEmpty());
  const auto& components = application->composition.components;
  EXPECT_EQ(std::ranges::count_if(components,
                                  [](const auto& component) {
                                    return component.name.ends_with(
                                        "Microphone");
                                  }),
            1);
  EXPECT_EQ(components.front().options.at("device"), "plughw:1");
}

// An error in the settings keeps its line.
TEST_F(VoiceTest, KeepsThePlacesOfMistakes) {
  settings("<Plugins><Plugin>NoSuchThing</Plugin></Plugins>"
           "<Scripts><Script>own.xml</Script></Scripts>");
  const auto application = load();
  ASSERT_TRUE(application);
  ASSERT_FALSE(application->findings.empty());
  EXPECT_EQ(application->findings.front().place.line, 2u);
}

} // namespace
} // namespace parlour::tools
