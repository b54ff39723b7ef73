#include "tests/tools/bench/speech/spoken_receptionist.hpp"
#include "tools/bench/speech/listener.hpp"
#include "tools/parlour/voice_test/speech_bank.hpp"

namespace parlour::tools {
namespace {

TEST(Listener, hears_and_understands) {
  const auto application = test::spoken_receptionist();
  const auto listener = Listener::start(application, true);
  ASSERT_TRUE(listener) << to_string(listener.error());

  const auto silence = (*listener)->hear(adapters::Sound(8'000));
  ASSERT_TRUE(silence);
  EXPECT_TRUE(silence->rejected);
  EXPECT_TRUE(silence->acts.empty());

  SpeechBank bank(application.plugins);
  const auto line = bank.speak("What time is it?", "en-us");
  ASSERT_TRUE(line);
  const auto heard = (*listener)->hear(**line);
  ASSERT_TRUE(heard);
  EXPECT_EQ(heard->rejected, heard->text.empty());

  EXPECT_FALSE((*listener)->understand("What time is it?").empty());
  EXPECT_TRUE((*listener)->understand("colourless green ideas").empty());
}

} // namespace
} // namespace parlour::tools
