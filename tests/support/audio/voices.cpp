#include "tests/support/audio/voices.hpp"

#include <array>
#include <map>
#include <random>

#include <flite/flite.h>

extern "C" {
cst_voice* register_cmu_us_rms(const char* folder);
cst_voice* register_cmu_us_slt(const char* folder);
cst_voice* register_cmu_us_awb(const char* folder);
cst_voice* register_cmu_us_kal16(const char* folder);
}

namespace parlour::test {

namespace {

// Owned by the library.
cst_voice* voice_of(const std::string& name) {
  static const bool is_ready = flite_init() == 0;
  static const std::map<std::string, cst_voice*> voices{
      {"rms", register_cmu_us_rms(nullptr)},
      {"slt", register_cmu_us_slt(nullptr)},
      {"awb", register_cmu_us_awb(nullptr)},
      {"kal16", register_cmu_us_kal16(nullptr)}};
  return is_ready ? voices.at(name) : nullptr;
}

constexpr std::array sentences{
    "The river ran high after three days of rain and the bridge was closed.",
    "She painted the old fence green because nobody liked the colour before.",
    "Most of the apples were eaten by birds long before the harvest began.",
    "He wrote nine letters to his brother and never got a single answer.",
    "A small boat crossed the bay while the lighthouse keeper slept.",
    "They argued about the price of wool until the market shut its gates.",
    "My grandmother kept her buttons in a tin that smelled of tea.",
    "The train was late again so we played cards on the platform.",
    "Nobody knew why the clock on the tower always struck thirteen.",
    "Two foxes live under the shed and come out when it gets dark."};

} // namespace

bool can_speak() {
  return true;
}

Sound spoken(const std::string& text, const std::string& voice) {
  cst_wave* wave = flite_text_to_wave(text.c_str(), voice_of(voice));
  if (!wave)
    return {};
  if (wave->sample_rate != adapters::speech_rate)
    cst_wave_resample(wave, adapters::speech_rate);
  Sound sound(wave->samples, wave->samples + wave->num_samples);
  delete_wave(wave);
  return sound;
}

Sound babble(std::uint64_t seed, std::int64_t milliseconds, double level) {
  std::mt19937_64 random(seed);
  Sound mixed(samples_in(milliseconds));
  for (const auto* voice : {"rms", "slt", "awb", "kal16", "slt", "rms"}) {
    auto at = static_cast<std::size_t>(random() % 16'000);
    while (at < mixed.size()) {
      auto sound = spoken(sentences[random() % sentences.size()], voice);
      const auto loud = speech_level_of(sound);
      sound = at_level(std::move(sound), loud, -36);
      add(mixed, sound, at);
      at += sound.size() + random() % 8'000;
    }
  }
  const auto now = level_of(mixed);
  return at_level(std::move(mixed), now, level);
}

} // namespace parlour::test
