// Telephone numbers strung from recordings of single digits, in files
// DIGIT_SPEAKER_INDEX.wav, as github.com/Jakobovski/free-spoken-digit-dataset
// has them. The same each time.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "adapters/audio/mixing.hpp"
#include "runtime/base/error.hpp"

namespace parlour::tools {

struct DigitString {
  std::string digits;
  std::vector<std::filesystem::path> files;
};

// So many numbers of eight digits by the speaker, whose recordings of each
// digit take turns at random. Empty if one of the digits has no recording.
std::vector<DigitString>
digit_strings(const std::vector<std::filesystem::path>& recordings,
              const std::string& speaker, std::size_t count);

// The recordings in the folder, or in its recordings/ or
// free-spoken-digit-dataset/recordings/, in order; empty if there are none.
std::vector<std::filesystem::path>
digit_recordings(const std::filesystem::path& folder);

// As it sounds: the recordings as they are, with 100 ms between them.
Expected<adapters::Sound> sound_of(const DigitString& string);

} // namespace parlour::tools
