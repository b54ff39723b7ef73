#include <cmath>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/audio/sound_file.hpp"
#include "adapters/endpointer/speech_endpointer.hpp"
#include "adapters/vad/adaptive_vad.hpp"
#include "runtime/plugin/adaptors.hpp"
#include "script/program/program.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tools/parlour/speech/ears.hpp"

namespace parlour::tools {
namespace {

using adapters::Sample;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

// Hears how many frames an utterance has.
class CountingASR : public ASRPlugin {
protected:
  Expected<void> on_start(const Options& options) override {
    mode_ = option_value(options, {{"mode", "", "how it behaves"}}, "mode");
    if (mode_ == "broken")
      return fail(ErrorKind::settings, "there is no model");
    return {};
  }
  void on_do_recognition(const Binary&) override {
    if (mode_ == "throws")
      throw std::runtime_error("no memory");
    if (++frames_ == 20)
      fire_partial("so far", 1, true);
  }
  void on_finish() override {
    if (mode_ == "rejects")
      fire_rejected("a noise");
    else
      fire_result(std::to_string(frames_) + " frames", 0.5, {"one", "two"},
                  {Map{{"word", "frames"}}});
    frames_ = 0;
  }
  void on_cancel() override {
    frames_ = 0;
  }

private:
  int frames_ = 0;
  std::string mode_;
};

// Spots its word in everything that is loud, once.
class LoudKeywords : public RolePlugin {
public:
  LoudKeywords() : RolePlugin("KeywordSpotter") {
    on("Process", &LoudKeywords::on_process);
  }

private:
  void on_process(const Binary& audio, std::int64_t position) {
    adapters::LevelMeter meter;
    meter.add(*adapters::speech_samples(audio));
    if (meter.peak() > -20 && !std::exchange(spotted_, true))
      fire_event("Keyword", {"wake up", 0.9, position});
  }

  bool spotted_ = false;
};

// The same by a server: it is there after a while, and each answer takes its
// time.
class FarKeywords : public RolePlugin {
public:
  FarKeywords() : RolePlugin("KeywordSpotter") {
    on("Process", &FarKeywords::on_process);
  }
  static PluginFactory factory() {
    PluginDescription description{
        "FarKeywords", {"KeywordSpotter"}, "spots what is loud, elsewhere"};
    description.options = {{"one-by-one", "", "as components that work aside"}};
    return {description, [] { return std::make_unique<FarKeywords>(); }};
  }

protected:
  Expected<void> on_start(const Options& options) override {
    host().available(false);
    if (!options.contains("one-by-one"))
      host().after(Milliseconds(100), [this] {
        is_there_ = true;
        host().available(true);
      });
    return {};
  }

private:
  void on_process(const Binary& audio, std::int64_t position) {
    adapters::LevelMeter meter;
    meter.add(*adapters::speech_samples(audio));
    if (is_there_ && meter.peak() > -20 && !std::exchange(spotted_, true))
      host().after(Milliseconds(40), [this, position] {
        fire_event("Keyword", {"wake up", 0.9, position});
      });
  }

  bool is_there_ = false;
  bool spotted_ = false;
};

class EarsTest : public testing::Test {
protected:
  EarsTest() {
    application.program = std::make_shared<script::Program>();
    application.folder = folder.path();
    add(adapters::adaptive_vad_factory());
    add(adapters::speech_endpointer_factory());
    PluginDescription description{"CountingASR", {"ASR"}, "counts"};
    description.options = {{"mode", "", "how it behaves"}};
    add({description, [] { return std::make_unique<CountingASR>(); }});
  }
  void add(PluginFactory factory) {
    auto name = factory.description.name;
    application.composition.components.push_back(
        {std::move(name), std::move(factory), {}, {}});
  }
  void recogniser(const std::string& mode) {
    application.composition.components.back().options["mode"] = mode;
  }
  // Noise that is as loud and as varied as speech, between silence.
  std::filesystem::path sound(const std::vector<int>& bursts,
                              std::size_t silence = 32'000) {
    std::vector<Sample> samples(16'000);
    for (const int time : bursts) {
      for (int i = 0; i < 16 * time; ++i)
        samples.push_back(static_cast<Sample>(8'000 * std::sin(0.05 * i) *
                                              std::sin(0.0011 * i)));
      samples.insert(samples.end(), silence, 0);
    }
    auto path = folder.path() / "sound.wav";
    auto writer = adapters::SoundFileWriter::create(path, {});
    EXPECT_TRUE(writer && writer->write(samples));
    return path;
  }

  test::TemporaryFolder folder;
  Application application;
};

TEST_F(EarsTest, TellsWhatEachStageMakesOfAFile) {
  auto ears = Ears::start(application);
  ASSERT_TRUE(ears) << ears.error().message;
  EXPECT_EQ((*ears)->recogniser(), "CountingASR");
  for (int again = 0; again < 2; ++again) {
    const auto heard = (*ears)->hear(sound({1'500, 1'000}));
    ASSERT_TRUE(heard) << heard.error().message;
    EXPECT_EQ(heard->length, 9'500); // two seconds of silence with it
    EXPECT_NEAR(heard->level.peak(), -12, 1);
    ASSERT_THAT(heard->speech, SizeIs(2));
    ASSERT_THAT(heard->turns, SizeIs(2));
    const auto& turn = heard->turns[0];
    EXPECT_NEAR(static_cast<double>(turn.begin), 1'000, 150);
    EXPECT_NEAR(static_cast<double>(turn.end), 2'500, 150);
    EXPECT_NEAR(static_cast<double>(heard->turns[1].begin), 4'500, 150);
    EXPECT_THAT(turn.text, HasSubstr("frames"));
    EXPECT_EQ(turn.confidence, Value(0.5));
    EXPECT_THAT(turn.alternatives, SizeIs(2));
    EXPECT_THAT(turn.words, SizeIs(1));
    ASSERT_THAT(turn.partials, SizeIs(1));
    EXPECT_EQ(turn.partials[0].text, "so far");
    EXPECT_EQ(turn.partials[0].ends, true);
  }
}

TEST_F(EarsTest, TellsThatThereIsNoSpeech) {
  auto ears = Ears::start(application);
  ASSERT_TRUE(ears);
  const auto heard = (*ears)->hear(sound({}));
  ASSERT_TRUE(heard);
  EXPECT_THAT(heard->speech, IsEmpty());
  EXPECT_THAT(heard->turns, IsEmpty());
}

TEST_F(EarsTest, TellsWhyNothingIsRecognised) {
  recogniser("rejects");
  auto ears = Ears::start(application);
  ASSERT_TRUE(ears);
  const auto heard = (*ears)->hear(sound({1'000}));
  ASSERT_TRUE(heard);
  ASSERT_THAT(heard->turns, SizeIs(1));
  EXPECT_EQ(heard->turns[0].rejected, "a noise");
}

TEST_F(EarsTest, SleepsUntilItsWordIsSaid) {
  add({{"LoudKeywords", {"KeywordSpotter"}, "spots what is loud"},
       [] { return std::make_unique<LoudKeywords>(); }});
  application.composition.components[1].options["sleeps-after"] = "10s";
  auto ears = Ears::start(application);
  ASSERT_TRUE(ears);
  const auto first = (*ears)->hear(sound({1'000}));
  ASSERT_TRUE(first);
  EXPECT_TRUE(first->sleeps);
  ASSERT_THAT(first->keywords, SizeIs(1));
  EXPECT_EQ(first->keywords[0].text, "wake up");
  EXPECT_NEAR(static_cast<double>(first->keywords[0].position), 1'000, 100);
  EXPECT_THAT(first->turns, SizeIs(1));
  const auto second = (*ears)->hear(sound({1'000}));
  ASSERT_TRUE(second);
  EXPECT_THAT(second->speech, SizeIs(1));
  EXPECT_THAT(second->turns, IsEmpty());
}

TEST_F(EarsTest, WaitsForWhoWorksElsewhere) {
  add(FarKeywords::factory());
  auto ears = Ears::start(application);
  ASSERT_TRUE(ears);
  const auto begin = std::chrono::steady_clock::now();
  const auto heard = (*ears)->hear(sound({500}, 3'200));
  const auto took = std::chrono::steady_clock::now() - begin;
  ASSERT_TRUE(heard);
  ASSERT_THAT(heard->keywords, SizeIs(1));
  EXPECT_NEAR(static_cast<double>(heard->keywords[0].position), 1'000, 100);
  EXPECT_THAT(heard->turns, SizeIs(1));
  EXPECT_GE(took, Milliseconds(heard->length - adapters::frame_time));
}

TEST_F(EarsTest, SaysWhoIsNotAvailable) {
  add(FarKeywords::factory());
  application.composition.components.back().options["one-by-one"] = "";
  auto ears = Ears::start(application);
  ASSERT_TRUE(ears);
  EXPECT_EQ((*ears)->hear(sound({})).error().message,
            "FarKeywords is not available");
}

TEST_F(EarsTest, SaysWhoThrows) {
  recogniser("throws");
  auto ears = Ears::start(application);
  ASSERT_TRUE(ears);
  EXPECT_EQ((*ears)->hear(sound({1'000})).error().message,
            "CountingASR: it throws 'no memory'");
}

TEST_F(EarsTest, SaysWhatIsMissing) {
  recogniser("broken");
  EXPECT_EQ(Ears::start(application).error().message,
            "CountingASR: there is no model");
  application.composition.components.pop_back();
  EXPECT_THAT(Ears::start(application).error().message,
              HasSubstr("no component of the role ASR"));
}

TEST_F(EarsTest, RefusesWhatIsNoSound) {
  auto ears = Ears::start(application);
  ASSERT_TRUE(ears);
  EXPECT_FALSE((*ears)->hear(folder.path() / "none.wav"));
}

} // namespace
} // namespace parlour::tools
