// Words in plain letters, for engines that know ASCII only.
#pragma once

#include <string>

namespace parlour::adapters::tts {

// "cafe" for "café", "..." for "…"; other scripts in Latin letters. Without
// blanks; empty if nothing is left. Not thread-safe: for an engine's thread.
std::string in_plain_letters(const std::string& word);

} // namespace parlour::adapters::tts
