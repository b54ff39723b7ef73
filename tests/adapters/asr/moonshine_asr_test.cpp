#include <gmock/gmock.h>

#include "adapters/asr/moonshine_asr.hpp"
#include "adapters/audio/pcm.hpp"
#include "runtime/plugin/conformance.hpp"
#include "runtime/plugin/test_host.hpp"
#include "runtime/text/json_text.hpp"
#include "tests/adapters/asr/fake_moonshine.hpp"

namespace parlour::adapters {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

constexpr Milliseconds patience{60'000};

class HostWithModel : public TestHost {
public:
  std::shared_ptr<const UnderstandingModel> understanding() const override {
    return model;
  }
  Expected<std::vector<std::string>> column(const std::string&) const override {
    return std::vector<std::string>{"Jeffery"};
  }

  const std::shared_ptr<UnderstandingModel> model =
      std::make_shared<UnderstandingModel>();
};

class MoonshineASRTest : public testing::Test {
protected:
  ~MoonshineASRTest() override {
    if (plugin)
      plugin->stop();
  }

  Expected<void> start(const std::string& mode, Options more = {}) {
    fake.emplace(mode);
    more.emplace("node", test::FakeMoonshine::interpreter());
    plugin = moonshine_asr_factory({fake->program()}).create();
    return plugin->start(host, more);
  }
  void send(const std::string& session, const std::string& command,
            std::vector<Value> params = {}) {
    Message message;
    message.session = session;
    message.command = command;
    message.params = std::move(params);
    message.correlation = 7;
    plugin->receive(message);
  }
  void speak(const std::string& session, int frames) {
    const std::vector<Sample> samples(frame_samples);
    for (int frame = 0; frame < frames; ++frame)
      send(session, "DoRecognition", {pcm_value(samples)});
  }
  // The next event with one of the names, as "session: Name[…]".
  std::string next(const std::vector<std::string>& names) {
    std::string found;
    host.wait(
        [&] {
          for (auto& event : host.take_events())
            events.push_back(std::move(event));
          while (!events.empty() && found.empty()) {
            const auto event = std::move(events.front());
            events.erase(events.begin());
            if (std::ranges::find(names, event.command) != names.end())
              found = event.session + ": " + event.command +
                      json_text(Value(event.params));
          }
          return !found.empty();
        },
        patience);
    return found;
  }
  std::string result() {
    return next({"RecognitionResult", "Rejected"});
  }
  std::string failure() {
    std::vector<std::string> failures;
    host.wait(
        [&] {
          failures = host.take_failures();
          return !failures.empty();
        },
        patience);
    return failures.size() == 1 ? failures.front() : "none, or too many";
  }

  // A line of the program that has the text.
  std::string log_with(const std::string& text) {
    std::string found;
    host.wait(
        [&] {
          for (const auto& line : host.take_logs())
            if (line.find(text) != std::string::npos)
              found = line;
          return !found.empty();
        },
        patience);
    return found;
  }

  HostWithModel host;
  std::optional<test::FakeMoonshine> fake;
  std::unique_ptr<IPlugin> plugin;
  std::vector<Message> events;
};

// -- what is expected ---------------------------------------------------------

TEST_F(MoonshineASRTest, NarrowsTheTurnsOfOneSession) {
  host.model->grammars = {{"size", "public <size> = small | large;", {}}};
  ASSERT_TRUE(start("behaves", {{"one-by-one", "true"}}));
  send("one", "SetGrammar", {Value(List{"size"})});
  speak("two", 1);
  speak("one", 1);
  EXPECT_THAT(log_with("narrow:"), HasSubstr("large;Large;"));
  send("one", "Finish");
  send("one", "SetGrammar", {Value(List{})});
  speak("one", 1);
  send("one", "Finish");
  EXPECT_TRUE(host.take_logs().empty());
}

TEST_F(MoonshineASRTest, TellsWhetherASentenceMayEnd) {
  host.model->grammars = {
      {"far", "public <far> = three hundred twenty so far [and on];", {}},
      {"further", "public <further> = six hundred forty so far away;", {}}};
  ASSERT_TRUE(start("behaves", {{"one-by-one", "true"}}));
  speak("one", 3);
  EXPECT_EQ(next({"Partial"}), R"(one: Partial["320 so far",1,true])");
  EXPECT_EQ(next({"Partial"}), R"(one: Partial["640 so far",2,false])");
  EXPECT_EQ(next({"Partial"}), R"(one: Partial["960 so far",3])");
}

// Engine rule 1.9.
TEST_F(MoonshineASRTest, PrefersTheNewValuesOfAColumn) {
  host.model->topics = {
      {"Visit", false, {{"Host", "query", {}, "db:staff.name"}}, {}}};
  ASSERT_TRUE(start("behaves", {{"one-by-one", "true"}}));
  EXPECT_THAT(log_with("words:"), HasSubstr("Jeffery;"));
  send("", "SetValues", {"db:staff.name", List{"Jeffery"}});
  send("", "SetValues", {"db:other.name", List{"Nobody"}});
  send("", "SetValues", {"db:staff.name", List{"Deborah"}});
  EXPECT_THAT(log_with("words:"), HasSubstr("Deborah;"));
}

TEST_F(MoonshineASRTest, StopsWhileItPreparesGrammars) {
  ASSERT_TRUE(start("behaves"));
  plugin->stop();
}

TEST_F(MoonshineASRTest, RecognisesATurn) {
  ASSERT_TRUE(start("behaves"));
  speak("one", 2);
  EXPECT_EQ(next({"Partial"}), R"(one: Partial["320 so far",1])");
  EXPECT_EQ(next({"Partial"}), R"(one: Partial["640 so far",2])");
  send("one", "Finish");
  EXPECT_EQ(result(), R"(one: RecognitionResult["640 samples at 5 pm.",0.75,)"
                      R"([{"text":"pm.","confidence":0.5}],)"
                      R"([{"text":"am.","confidence":0.75}]])");
}

TEST_F(MoonshineASRTest, KeepsConversationsApart) {
  ASSERT_TRUE(start("behaves"));
  speak("one", 1);
  speak("two", 2);
  send("one", "Finish");
  speak("one", 3);
  EXPECT_THAT(result(), StartsWith("one: RecognitionResult[\"320 samples"));
  send("two", "Finish");
  EXPECT_THAT(result(), StartsWith("two: RecognitionResult[\"640 samples"));
  send("one", "Finish");
  EXPECT_THAT(result(), StartsWith("one: RecognitionResult[\"960 samples"));
}

TEST_F(MoonshineASRTest, HearsHalfAMinute) {
  ASSERT_TRUE(start("behaves"));
  speak("one", 1'600);
  send("one", "Finish");
  EXPECT_THAT(result(), StartsWith("one: RecognitionResult[\"480000 samples"));
}

TEST_F(MoonshineASRTest, RejectsSilence) {
  ASSERT_TRUE(start("behaves"));
  send("one", "Finish");
  EXPECT_EQ(result(), R"(one: Rejected["Nothing was heard."])");
  send("one", "DoRecognition", {pcm_value(std::vector<Sample>(10))});
  send("one", "Finish");
  EXPECT_EQ(result(), R"(one: Rejected["No words were heard."])");
}

TEST_F(MoonshineASRTest, CancelsATurn) {
  ASSERT_TRUE(start("hangs"));
  speak("one", 1);
  send("one", "Cancel");
  send("one", "Finish");
  EXPECT_EQ(result(), R"(one: Rejected["Nothing was heard."])");
  speak("one", 1);
  send("one", "Finish");
  send("one", "Cancel");
  EXPECT_EQ(result(), R"(one: Rejected["The turn is cancelled."])");
}

TEST_F(MoonshineASRTest, RefusesOtherAudio) {
  ASSERT_TRUE(start("behaves"));
  send("one", "DoRecognition",
       {pcm_value(std::vector<Sample>(10), {.rate = 8'000})});
  EXPECT_THAT(next({"Failed"}), HasSubstr("16,000 samples a second"));
}

TEST_F(MoonshineASRTest, AnswersAtOnceInVirtualTime) {
  ASSERT_TRUE(start("behaves", {{"one-by-one", "true"}}));
  speak("one", 1);
  send("one", "Finish");
  EXPECT_EQ(host.take_events().back().command, "RecognitionResult");
}

TEST_F(MoonshineASRTest, AnswersToNobodyAreDropped) {
  ASSERT_TRUE(start("answers others"));
  speak("one", 1);
  send("one", "Finish");
  EXPECT_THAT(result(), StartsWith("one: RecognitionResult[\"320 samples"));
}

// -- when the program misbehaves ----------------------------------------------

TEST_F(MoonshineASRTest, FailsWhenItsProgramDies) {
  ASSERT_TRUE(start("dies"));
  speak("one", 1);
  send("one", "Finish");
  EXPECT_EQ(result(), "one: Rejected[\"The recogniser's program has ended: it "
                      "ended with status 4\"]");
  EXPECT_THAT(failure(), HasSubstr("it ended with status 4"));
  send("one", "Finish");
  EXPECT_THAT(result(), HasSubstr("it ended with status 4"));
  speak("one", 1);
}

TEST_F(MoonshineASRTest, FailsWhenItsProgramHangs) {
  ASSERT_TRUE(start("hangs", {{"timeout", "10ms"}}));
  speak("one", 1);
  send("one", "Finish");
  EXPECT_THAT(result(), HasSubstr("it does not answer"));
  EXPECT_THAT(failure(), HasSubstr("it does not answer"));
}

TEST_F(MoonshineASRTest, AHangDoesNotStopVirtualTime) {
  ASSERT_TRUE(start("hangs", {{"timeout", "10ms"}, {"one-by-one", "true"}}));
  speak("one", 1);
  send("one", "Finish");
  EXPECT_THAT(result(), HasSubstr("it does not answer"));
}

TEST_F(MoonshineASRTest, FailsWhenItsProgramCannotLoad) {
  ASSERT_TRUE(start("refuses"));
  EXPECT_EQ(failure(), "The recogniser's program has ended: there is no model");
}

TEST_F(MoonshineASRTest, NamesTheWayOutWhereThingsAreMissing) {
  const auto started = start("behaves", {{"node", "no-such-node"}});
  ASSERT_FALSE(started);
  EXPECT_THAT(started.error().message,
              HasSubstr("`tools/dependencies ears` installs"));
}

TEST_F(MoonshineASRTest, EndsItsProgramAndAnswersWhatIsOpen) {
  ASSERT_TRUE(start("hangs"));
  speak("one", 1);
  send("one", "Finish");
  plugin->stop();
  EXPECT_EQ(result(), R"(one: Rejected["The component is stopped."])");
  EXPECT_THAT(host.take_failures(), IsEmpty());
}

TEST_F(MoonshineASRTest, Conforms) {
  fake.emplace("behaves");
  TestOptions terms;
  terms.deadline = patience;
  terms.options = {{"node", test::FakeMoonshine::interpreter()}};
  EXPECT_THAT(
      conformance_errors(moonshine_asr_factory({fake->program()}), terms),
      IsEmpty());
}

} // namespace
} // namespace parlour::adapters
