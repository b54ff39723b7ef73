#include "tools/bench/speech/digit_strings.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "adapters/audio/sound_file_frames.hpp"
#include "runtime/base/random.hpp"

namespace parlour::tools {

namespace {

namespace fs = std::filesystem;
using adapters::Sample;
using adapters::Sound;

constexpr std::size_t length = 8;
constexpr std::int64_t pause = 100; // ms
constexpr std::uint64_t seed = 2026;
constexpr double level = -26;

// By digit, those of the speaker.
using Recordings = std::array<std::vector<fs::path>, 10>;

Recordings recordings_of(const std::vector<fs::path>& all,
                         const std::string& speaker) {
  Recordings found;
  for (const auto& file : all) {
    const auto name = file.stem().string();
    const auto digit =
        static_cast<std::size_t>(name.empty() ? 10 : name[0] - '0');
    if (digit < found.size() && name.substr(1).starts_with("_" + speaker + "_"))
      found.at(digit).push_back(file);
  }
  return found;
}

Expected<Sound> read(const fs::path& file) {
  auto frames = adapters::SoundFileFrames::open(file, {}, {});
  if (!frames)
    return tl::make_unexpected(frames.error());
  Sound sound;
  for (std::vector<Sample> frame; frames->next(frame);)
    sound.insert(sound.end(), frame.begin(), frame.end());
  return sound;
}

} // namespace

std::vector<DigitString> digit_strings(const std::vector<fs::path>& recordings,
                                       const std::string& speaker,
                                       std::size_t count) {
  const auto found = recordings_of(recordings, speaker);
  if (std::ranges::any_of(found, &std::vector<fs::path>::empty))
    return {};
  Random random(seed);
  std::vector<DigitString> strings(count);
  for (auto& string : strings)
    for (std::size_t i = 0; i < length; ++i) {
      const auto digit = random.next() % found.size();
      const auto& files = found.at(digit);
      string.digits += static_cast<char>('0' + digit);
      string.files.push_back(files[random.next() % files.size()]);
    }
  return strings;
}

std::vector<fs::path> digit_recordings(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& each :
       {folder, folder / "recordings",
        folder / "free-spoken-digit-dataset" / "recordings"}) {
    std::error_code none;
    for (const auto& file : fs::directory_iterator(each, none))
      if (file.path().extension() == ".wav")
        files.push_back(file.path());
  }
  std::ranges::sort(files);
  return files;
}

Expected<Sound> sound_of(const DigitString& string) {
  Sound all;
  for (const auto& file : string.files) {
    const auto digit = read(file);
    if (!digit)
      return digit;
    all.insert(all.end(), digit->begin(), digit->end());
    all.resize(all.size() + adapters::samples_in(pause));
  }
  const auto now = adapters::speech_level_of(all);
  return adapters::at_level(std::move(all), now, level);
}

} // namespace parlour::tools
