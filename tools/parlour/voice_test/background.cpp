#include "tools/parlour/voice_test/background.hpp"

#include <array>
#include <charconv>
#include <random>

#include <fmt/format.h>

namespace parlour::tools {

namespace {

using adapters::Sound;
using Kind = NoiseWish::Kind;

constexpr std::int64_t length = 20'000; // ms
constexpr std::uint64_t seed = 1;
// Each of them speaks all the time, with short pauses.
constexpr std::size_t speakers = 6;

constexpr std::array<std::pair<std::string_view, Kind>, 3> kinds{
    {{"pink", Kind::pink}, {"white", Kind::white}, {"babble", Kind::babble}}};

constexpr std::array voices{"slt", "rms", "awb", "kal16"};

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

std::vector<std::string> other_voices(const std::string& user) {
  std::vector<std::string> others;
  for (const auto* voice : voices)
    if (voice != user)
      others.emplace_back(voice);
  return others;
}

// One voice after the other speaks sentences until the end.
Expected<Sound> babble(const std::string& user, double level,
                       SpeechBank& bank) {
  std::mt19937_64 random(seed);
  const auto others = other_voices(user);
  Sound mixed(adapters::samples_in(length));
  for (std::size_t speaker = 0; speaker < speakers; ++speaker) {
    const auto& voice = others[speaker % others.size()];
    auto at = static_cast<std::size_t>(random() % adapters::samples_in(1'000));
    while (at < mixed.size()) {
      const auto spoken =
          bank.speak(sentences[random() % sentences.size()], voice);
      if (!spoken)
        return tl::make_unexpected(spoken.error());
      // Quieter, so that their sum is not cut off.
      adapters::add(mixed, adapters::at_level(**spoken, 0, -10), at);
      at += (*spoken)->size() + random() % adapters::samples_in(500);
    }
  }
  const auto now = adapters::level_of(mixed);
  return adapters::at_level(std::move(mixed), now, level);
}

} // namespace

Expected<NoiseWish> read_noise(std::string_view text) {
  if (text.empty() || text == "none")
    return NoiseWish{};
  for (const auto& [name, kind] : kinds) {
    if (!text.starts_with(name))
      continue;
    auto rest = text.substr(name.size());
    if (rest.starts_with('@'))
      rest.remove_prefix(1);
    NoiseWish noise{kind, 0};
    const auto* const end = rest.data() + rest.size();
    const auto read = std::from_chars(rest.data(), end, noise.distance);
    if (read.ec == std::errc() && read.ptr == end && noise.distance >= -20 &&
        noise.distance <= 60)
      return noise;
  }
  return fail(ErrorKind::settings,
              fmt::format("a noise is pink, white or babble, and how many dB "
                          "the speech is louder, such as babble@20, not '{}'",
                          text));
}

std::string to_string(const NoiseWish& noise) {
  for (const auto& [name, kind] : kinds)
    if (noise.kind == kind)
      return fmt::format("{}@{:g}", name, noise.distance);
  return "none";
}

Expected<Sound> make_noise(const NoiseWish& noise,
                           const std::string& user_voice, SpeechBank& bank) {
  const auto level = SpeechBank::level - noise.distance;
  switch (noise.kind) {
  case Kind::pink:
    return adapters::pink_noise(seed, length, level);
  case Kind::white:
    return adapters::white_noise(seed, length, level);
  case Kind::babble:
    return babble(user_voice, level, bank);
  case Kind::none:
    break;
  }
  return Sound();
}

} // namespace parlour::tools
