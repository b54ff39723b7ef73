#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/plugin/adaptors.hpp"
#include "runtime/plugin/conformance.hpp"
#include "tests/support/fake_plugin_host.hpp"

namespace parlour {
namespace {

using test::FakePluginHost;
using test::message;
using testing::ElementsAre;
using testing::IsEmpty;

class Ear : public MicrophonePlugin {
protected:
  void on_start_mic() override {
    fire_started();
    fire_buffer_full({"pcm", {}}, 20);
  }
  void on_stop_mic() override {
    fire_stopped();
  }
};

class Detector : public VADPlugin {
protected:
  void on_process(const Binary&,
                  std::optional<std::int64_t> position) override {
    fire_speech_started(position.value_or(20));
    fire_speech_ended(40);
  }
  void on_reset() override {}
};

class Recogniser : public ASRPlugin {
protected:
  void on_do_recognition(const Binary&) override {
    fire_partial("hel", 1);
  }
  void on_finish() override {
    fire_result("hello", 0.9);
  }
  void on_cancel() override {
    fire_rejected("cancelled");
  }
};

class Voice : public TTSPlugin {
protected:
  void on_speak(const std::string& text, Utterance utterance,
                std::optional<bool>) override {
    fire_mark(utterance, text, 0);
    fire_audio({"pcm", {}}, utterance);
    fire_finished(utterance);
  }
  void on_stop(std::optional<Utterance> utterance) override {
    fire_finished(utterance.value_or(0));
  }
};

class Understanding : public NLUPlugin {
protected:
  std::vector<Value> understand(const std::string& text,
                                const Map& context) const override {
    if (text == "what?")
      return {};
    return {Map{{"act", "inform"}, {"seen", static_cast<int>(context.size())}}};
  }
};

class Words : public NLGPlugin {
protected:
  std::optional<std::string> generate(const Value& what,
                                      const Value&) const override {
    if (what.if_map())
      return std::nullopt;
    return what.text() + "!";
  }
};

class Store : public DatabasePlugin {
protected:
  void on_connect(std::optional<Value>) override {
    fire_result();
  }
  void on_query(const std::string& sql, const List& values,
                std::optional<bool>) override {
    fire_result({{sql}, values});
  }
  void on_begin() override {
    fire_error({ErrorKind::offline, "gone", {}});
  }
  void on_commit() override {
    fire_result();
  }
  void on_rollback() override {
    fire_result();
  }
};

class Sage : public KnowledgePlugin {
protected:
  void on_ask(const std::string& source, const Value& question) override {
    fire_result({{source}, {question}}, question, {"floor"});
  }
};

template <class Class>
std::vector<std::string> tell(std::string command,
                              std::vector<Value> params = {}) {
  FakePluginHost host;
  Class plugin;
  EXPECT_TRUE(plugin.start(host, {}));
  plugin.receive(message(std::move(command), std::move(params)));
  return host.take_events();
}

// The adaptors and the table of roles say the same.
template <class Class>
void expect_all_commands() {
  const Class plugin;
  std::set<std::string> known;
  for (const auto& command : plugin.role().commands)
    known.insert(command.name);
  const auto handled = plugin.commands();
  EXPECT_EQ(std::set<std::string>(handled.begin(), handled.end()), known)
      << plugin.role().name;
}

TEST(Adaptors, HandleTheCommandsOfTheirRoles) {
  expect_all_commands<Ear>();
  expect_all_commands<Detector>();
  expect_all_commands<Recogniser>();
  expect_all_commands<Voice>();
  expect_all_commands<Store>();
  expect_all_commands<Sage>();
}

template <class Class>
std::vector<std::string> wrong_with(const std::string& role) {
  PluginFactory factory;
  factory.description.name = "It";
  factory.description.roles = {role};
  factory.description.sentence = "is tried out";
  factory.description.events = {{"NoPhrase", "act, topic", Reply::none}};
  factory.create = [] { return std::make_unique<Class>(); };
  return conformance_errors(factory, {});
}

TEST(Adaptors, MakePluginsThatConform) {
  EXPECT_THAT(wrong_with<Ear>("Microphone"), IsEmpty());
  EXPECT_THAT(wrong_with<Detector>("VAD"), IsEmpty());
  EXPECT_THAT(wrong_with<Recogniser>("ASR"), IsEmpty());
  EXPECT_THAT(wrong_with<Voice>("TTS"), IsEmpty());
  EXPECT_THAT(wrong_with<Understanding>("NLU"), IsEmpty());
  EXPECT_THAT(wrong_with<Words>("NLG"), IsEmpty());
  EXPECT_THAT(wrong_with<Store>("Database"), IsEmpty());
  EXPECT_THAT(wrong_with<Sage>("Knowledge"), IsEmpty());
}

TEST(Adaptors, OfSound) {
  EXPECT_THAT(tell<Ear>("start_mic").size(), 2u);
  EXPECT_THAT(tell<Ear>("SetFormat", {8000, 2}),
              ElementsAre("Failed(the format 8000 Hz, 2 channels cannot be "
                          "had)"));
  EXPECT_THAT(tell<Detector>("Process", {Binary{}}),
              ElementsAre("SpeechStarted(20)", "SpeechEnded(40)"));
  EXPECT_THAT(tell<Recogniser>("DoRecognition", {Binary{}}),
              ElementsAre("Partial(hel, 1)"));
  EXPECT_THAT(tell<Recogniser>("Cancel"), ElementsAre("Rejected(cancelled)"));
  EXPECT_THAT(tell<Voice>("Stop"), ElementsAre("Finished(0)"));
  EXPECT_THAT(tell<Voice>("Stop", {4}), ElementsAre("Finished(4)"));
  EXPECT_THAT(tell<Voice>("SetVoice", {"Ada"}),
              ElementsAre("Failed(there is no voice 'Ada')"));
}

// Audio belongs to nobody's request.
TEST(Adaptors, AMicrophonesAudioAnswersNobody) {
  FakePluginHost host;
  Ear ear;
  ASSERT_TRUE(ear.start(host, {}));
  ear.receive(message("start_mic"));
  ASSERT_EQ(host.events.size(), 2u);
  EXPECT_EQ(host.events[0].correlation, 7u);
  EXPECT_EQ(host.events[1].command, "BufferFull");
  EXPECT_EQ(host.events[1].correlation, 0u);
}

TEST(Adaptors, OfWords) {
  EXPECT_THAT(tell<Understanding>("DoNLU", {"hi", Map{{"now", 1}}}),
              ElementsAre("FrameInfo({act: inform, seen: 1})"));
  EXPECT_THAT(tell<Understanding>("DoNLU", {"what?"}),
              ElementsAre("NoResult(what?)"));
  EXPECT_THAT(tell<Understanding>("DoNLU"), ElementsAre("NoResult()"));
  EXPECT_THAT(tell<Words>("Generate", {"hi"}), ElementsAre("Speak(hi!)"));
  EXPECT_THAT(tell<Words>("Generate", {Map{{"act", "ask"}, {"topic", "Taxi"}}}),
              ElementsAre("Speak()", "NoPhrase(ask, Taxi)"));
}

TEST(Adaptors, OfWhatIsKnown) {
  EXPECT_THAT(tell<Store>("Begin"), ElementsAre("Error(Offline, gone)"));
  EXPECT_THAT(tell<Store>("Query", {"select 1"}),
              ElementsAre("Error(Refused, Query takes a list as its parameter "
                          "2, 'values', which is missing)"));
  EXPECT_EQ(tell<Store>("Query", {"select 1", List{2}}).size(), 1u);
  EXPECT_EQ(tell<Sage>("Ask", {"aiml", "who are you"}).size(), 1u);
}

} // namespace
} // namespace parlour
