#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/tts/speech_engine.hpp"
#include "tests/adapters/tts/fake_synthesizer.hpp"

namespace parlour::adapters::tts {
namespace {

using testing::ElementsAre;

class SpeechEngineTest : public testing::Test {
protected:
  static std::shared_ptr<SpeechJob> job(const std::string& voice,
                                        const std::string& text) {
    VoiceSettings settings;
    settings.voice = voice;
    return std::make_shared<SpeechJob>(text, PieceLength{1, 100}, settings,
                                       Milliseconds(2'000), [] {});
  }

  test::FakeSynthesizerState state;
  SharedEngine shared{[this] { return test::make_fake_synthesizer(state); }};
};

TEST_F(SpeechEngineTest, takes_a_piece_of_each_in_turn) {
  const auto engine = *shared.use();
  const auto first = job("anna", test::words(40));
  const auto second = job("berta", test::words(40));
  state.close();
  engine->go_on(first);
  state.wait_for_caller();
  engine->go_on(second);
  engine->go_on(second); // it has its turn already
  state.open();
  first->await(4'000);
  second->await(4'000);
  EXPECT_THAT(state.voices(), ElementsAre("anna", "berta", "anna", "berta"));
}

TEST_F(SpeechEngineTest, does_tasks_between_pieces) {
  const auto engine = *shared.use();
  const auto whole = job("anna", test::words(40));
  engine->go_on(whole);
  int runs = 0;
  engine->run([&](Synthesizer& synthesizer) {
    runs += synthesizer.check_voice("anna").has_value();
  });
  EXPECT_EQ(runs, 1);
  whole->cancel();
}

TEST_F(SpeechEngineTest, is_one_as_long_as_it_is_used) {
  auto first = *shared.use();
  auto second = *shared.use();
  EXPECT_EQ(first.get(), second.get());
  first.reset();
  EXPECT_EQ(state.instances(), 1);
  second.reset();
  EXPECT_EQ(state.instances(), 0);
  EXPECT_TRUE(shared.use());
}

TEST_F(SpeechEngineTest, says_why_there_is_none) {
  state.is_missing = true;
  EXPECT_FALSE(shared.use());
  state.is_missing = false;
  EXPECT_TRUE(shared.use());
}

} // namespace
} // namespace parlour::adapters::tts
