// The noise behind what users say in a conversation by voice.
#pragma once

#include <string>
#include <string_view>

#include "tools/parlour/voice_test/speech_bank.hpp"

namespace parlour::tools {

// What --noise and a line's noise= ask for.
struct NoiseWish {
  enum class Kind { none, pink, white, babble };
  Kind kind = Kind::none;
  double distance = 0; // dB that the speech is louder

  auto operator<=>(const NoiseWish&) const = default;
};

// "babble@20", "pink@10", "white@15"; "babble20" is the same as "babble@20".
// "none" and an empty text are none.
Expected<NoiseWish> read_noise(std::string_view text);
// As it is written: "babble@20", "none".
std::string to_string(const NoiseWish& noise);

// Some seconds of it, to be repeated, for speech at SpeechBank::level. Babble
// is made of several voices, with sentences that belong to no application; the
// voice of the user is not among them. Empty if there is none.
Expected<adapters::Sound> make_noise(const NoiseWish& noise,
                                     const std::string& user_voice,
                                     SpeechBank& bank);

} // namespace parlour::tools
