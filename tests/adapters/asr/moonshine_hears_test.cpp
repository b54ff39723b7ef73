// MoonshineASR with its real program and weights: what flite says, it hears.
// Skipped where `tools/dependencies ears` or flite has not been installed.
#include <cstdlib>
#include <cstring>

#include <gmock/gmock.h>

#include "adapters/asr/moonshine_asr.hpp"
#include "adapters/audio/pcm.hpp"
#include "runtime/base/outside/file_bytes.hpp"
#include "runtime/plugin/test_host.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::adapters {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr Milliseconds patience{300'000};
constexpr std::size_t wav_header = 44; // bytes

std::filesystem::path program() {
  return test::source_path("tools/agents/moonshine/moonshine.mjs");
}

bool has_packages() {
  return std::filesystem::exists(program().parent_path() / "node_modules") &&
         std::system("command -v node > /dev/null") == 0;
}

// Knows the names of two people.
class Desk : public TestHost {
public:
  std::shared_ptr<const UnderstandingModel> understanding() const override {
    auto model = std::make_shared<UnderstandingModel>();
    TopicModel topic;
    topic.slots.emplace_back();
    topic.slots.back().name = "Host";
    topic.slots.back().values = {"Jeffery Ho", "Catherine Neo"};
    topic.name = "Visit";
    topic.slots.push_back({"Guest", "query", {}, "db:guests.name"});
    model->topics.push_back(std::move(topic));
    model->grammars = {
        {"visit",
         "public <visit> = i have an appointment with @Visit.Host;",
         {}},
        {"size", "public <size> = a chai | a mocha;", {}}};
    return model;
  }
  Expected<std::vector<std::string>> column(const std::string&) const override {
    return std::vector<std::string>{"Siti Aminah"};
  }
};

class MoonshineHears : public testing::Test {
protected:
  void SetUp() override {
    if (!has_packages())
      GTEST_SKIP() << "not tried: `tools/dependencies ears` installs what it "
                      "needs";
    if (std::system("command -v flite > /dev/null") != 0)
      GTEST_SKIP() << "not tried: flite, whose voice it would hear, is not "
                      "installed";
    plugin = moonshine_asr_factory({program()}).create();
    const auto started =
        plugin->start(host, {{"timeout", "5m"}, {"one-by-one", "true"}});
    ASSERT_TRUE(started) << to_string(started.error());
  }
  void TearDown() override {
    if (plugin)
      plugin->stop();
  }

  void send(const std::string& command, std::vector<Value> params = {}) {
    Message message;
    message.session = "one";
    message.command = command;
    message.params = std::move(params);
    plugin->receive(message);
  }
  void speak(const std::string& text) {
    const auto file = folder.path() / "said.wav";
    const auto command =
        "flite -voice rms -t '" + text + "' -o '" + file.string() + "'";
    ASSERT_EQ(std::system(command.c_str()), 0);
    const auto said = read_file(file);
    ASSERT_TRUE(said);
    std::vector<Sample> samples((said->size() - wav_header) / sizeof(Sample));
    std::memcpy(samples.data(), said->data() + wav_header,
                samples.size() * sizeof(Sample));
    for (std::span<const Sample> rest = samples; !rest.empty();) {
      const auto count = std::min(rest.size(), frame_samples);
      send("DoRecognition", {pcm_value(rest.first(count))});
      rest = rest.subspan(count);
    }
  }
  Message answer() {
    Message found;
    host.wait(
        [&] {
          for (auto& event : host.take_events())
            if (event.command != "Partial")
              found = std::move(event);
          return !found.command.empty();
        },
        patience);
    return found;
  }

  test::TemporaryFolder folder;
  Desk host;
  std::unique_ptr<IPlugin> plugin;
};

TEST_F(MoonshineHears, SentencesWithTheWordsOfTheApplication) {
  speak("I have an appointment with Catherine Neo.");
  send("Finish");
  const auto result = answer();
  ASSERT_EQ(result.command, "RecognitionResult");
  EXPECT_THAT(result.params.at(0).text(),
              StartsWith("I have an appointment with Catherine Neo"));
  EXPECT_GT(result.params.at(1).number_or(0), 0);
  EXPECT_FALSE(result.params.at(2).if_list()->empty());
  EXPECT_EQ(result.params.at(3).if_list()->size(), 7U);
}

// Engine rule 1.9.
TEST_F(MoonshineHears, ANewNameInTheNextTurn) {
  send("SetValues", {"db:guests.name", List{"Siti Aminah", "Deborah Quoos"}});
  speak("My name is Deborah Quoos.");
  send("Finish");
  EXPECT_THAT(answer().params.at(0).text(), HasSubstr("Deborah Quoos"));
}

TEST_F(MoonshineHears, TheWordsOfAGrammarWhereItIsNarrowed) {
  send("SetGrammar", {Value(List{"size"})});
  speak("A chai.");
  send("Finish");
  EXPECT_THAT(answer().params.at(0).text(), HasSubstr("chai"));
}

TEST_F(MoonshineHears, WhereASentenceMayEnd) {
  speak("I have an appointment with Catherine Neo.");
  send("DoRecognition", {pcm_value(std::vector<Sample>(16'000))});
  Message partial;
  ASSERT_TRUE(host.wait(
      [&] {
        for (auto& event : host.take_events())
          if (event.command == "Partial")
            partial = std::move(event);
        return partial.params.size() > 2 && bool(partial.params[2]);
      },
      patience));
  EXPECT_THAT(partial.params[0].text(), HasSubstr("Catherine Neo"));
}

TEST_F(MoonshineHears, NumbersAsFigures) {
  speak("My number is nine, one, two, three, four, five, six, seven.");
  send("Finish");
  EXPECT_THAT(answer().params.at(0).text(), HasSubstr("91234567"));
}

TEST_F(MoonshineHears, NothingInSilence) {
  send("DoRecognition", {pcm_value(std::vector<Sample>(16'000))});
  send("Finish");
  EXPECT_EQ(answer().command, "Rejected");
}

} // namespace
} // namespace parlour::adapters
