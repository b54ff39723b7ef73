#include "adapters/audio/alsa/alsa_device_list.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>
#include <string_view>
#include <utility>

#include <alsa/asoundlib.h>

namespace parlour::adapters {

namespace {

struct FreeHints {
  void operator()(void** hints) const {
    snd_device_name_free_hint(hints);
  }
};
struct FreeText {
  void operator()(char* text) const {
    std::free(text);
  }
};

std::string hint_of(const void* hint, const char* what) {
  const std::unique_ptr<char, FreeText> text(
      snd_device_name_get_hint(hint, what));
  return text ? text.get() : "";
}

// Plug-ins of alsa-lib that are no devices, and channels of one that is listed.
bool is_device(std::string_view name) {
  constexpr std::array<std::string_view, 18> others = {
      "null",   "samplerate", "speexrate", "lavrate", "speex",
      "upmix",  "vdownmix",   "jack",      "oss",     "a52",
      "hw",     "front",      "surround",  "iec958",  "dmix",
      "dsnoop", "usbstream",  "sysdefault"};
  const auto kind = name.substr(0, name.find(':'));
  return std::ranges::none_of(others, [&](std::string_view other) {
    return kind == other || (other == "surround" && kind.starts_with(other));
  });
}

std::string in_one_line(std::string text) {
  for (auto at = text.find('\n'); at != std::string::npos;
       at = text.find('\n', at))
    text.replace(at, 1, ", ");
  return text;
}

} // namespace

Expected<std::vector<SoundDevice>> list_sound_devices() {
  void** all = nullptr;
  std::vector<SoundDevice> devices;
  if (snd_device_name_hint(-1, "pcm", &all) < 0)
    return devices;
  const std::unique_ptr<void*, FreeHints> hints(all);
  for (auto** hint = all; *hint; ++hint) {
    const auto name = hint_of(*hint, "NAME");
    const auto direction = hint_of(*hint, "IOID"); // empty: both
    if (is_device(name))
      devices.push_back({name, in_one_line(hint_of(*hint, "DESC")),
                         direction != "Output", direction != "Input"});
  }
  return devices;
}

} // namespace parlour::adapters
