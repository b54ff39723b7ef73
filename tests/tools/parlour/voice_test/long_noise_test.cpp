// An hour of noise, in virtual time: it is hardly ever taken for speech, costs
// no memory, and whoever speaks after it is heard.
#include <fstream>

#include <unistd.h>

#include "tests/tools/parlour/voice_test/spoken_application.hpp"
#include "tools/parlour/voice_test/row_runner.hpp"

namespace parlour::tools {
namespace {

// Sanitizers keep what is freed.
#ifdef __SANITIZE_ADDRESS__
constexpr bool counts_memory = false;
#else
constexpr bool counts_memory = true;
#endif

// What is in memory, in KiB.
long resident() {
  std::ifstream file("/proc/self/statm");
  long all = 0;
  long pages = 0;
  file >> all >> pages;
  return pages * (sysconf(_SC_PAGESIZE) / 1024);
}

// Noise that becomes louder and weaker, as traffic does: 6 dB in ten seconds.
adapters::Sound traffic() {
  const auto steady = adapters::pink_noise(7, 20'000, SpeechBank::level - 15);
  auto sound = steady;
  for (std::size_t i = 0; i < sound.size(); ++i) {
    const auto turn = 2 * std::numbers::pi * static_cast<double>(i) /
                      static_cast<double>(sound.size());
    sound[i] = static_cast<adapters::Sample>(steady[i] *
                                             std::exp2(std::sin(turn) / 2));
  }
  return sound;
}

class LongNoise : public SpokenTest {
protected:
  LongNoise() {
    const std::string lasting = "<sessions closes-after=\"3h\"/>";
    typed = load(lasting, script);
    auto seated =
        load(seat + lasting,
             std::string("<include href=\"parlour:voice\"/>") + script);
    EXPECT_FALSE(seated.has_errors()) << findings(seated);
    spoken.program = seated.program;
    EXPECT_TRUE(bank.speak("one", "rms"));
    EXPECT_TRUE(bank.speak("two", "rms"));
  }
  // What was heard of a word, then the time, then another word. The first
  // `typed_rows` words are typed.
  std::vector<Row> wait(const std::string& time, std::size_t typed_rows = 0) {
    const auto told =
        conversation("U: one\nR~ .*\nwait " + time + "\nU: two\nR~ .*\n");
    const auto expected = hold_by_text(typed, told).rows;
    hears->assign({"one", "two"});
    return hold_by_voice(spoken, told,
                         {&bank, "rms", traffic(), false, nullptr}, expected,
                         typed_rows)
        .rows;
  }

  SpeechBank bank{std::make_shared<test::HummingVoices>()};
};

// Turns that the noise opens would be heard before the second word.
TEST_F(LongNoise, IsNoSpeechAndCostsNoMemory) {
  (void)wait("5m");
  const auto before = resident();
  auto rows = wait("1h");
  const auto after = resident();
  ASSERT_FALSE(rows.empty());
  EXPECT_GE(rows[0].heard.size(), 1u);
  EXPECT_LE(rows[0].heard.size(), 1u + 6u);
  if (counts_memory) {
    EXPECT_LE(after - before, 4'096);
  }
  // A turn of the noise ends the run before the second word.
  if (rows.size() == 1)
    rows = wait("1h", 1);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[1].heard.size(), 1u);
}

} // namespace
} // namespace parlour::tools
