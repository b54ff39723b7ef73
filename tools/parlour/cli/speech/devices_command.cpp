#include <algorithm>
#include <ostream>

#include <fmt/format.h>

#include "adapters/audio/alsa/alsa_device_list.hpp"
#include "adapters/audio/alsa/device_trial.hpp"
#include "tools/parlour/application/plugins/catalogue.hpp"
#include "tools/parlour/cli/commands.hpp"
#include "tools/parlour/console/exit_code.hpp"
#include "tools/parlour/talk/voice_progress.hpp"

namespace parlour::tools {

namespace {

using adapters::LevelMeter;
using adapters::SoundDevice;

constexpr Milliseconds tone_time{1'000};
// Of the levels, ten of which come in a second.
constexpr int shown_each = 2;
// A room without speech is between these two.
constexpr double no_sound = -75;   // decibels
constexpr double loud_speech = -6; // a peak
constexpr double much_clipped = 0.001;

// -- the list
// ------------------------------------------------------------------

void list(const std::vector<SoundDevice>& devices, bool SoundDevice::*can,
          const std::string& what, const std::string& option,
          std::ostream& out) {
  const bool any = std::ranges::any_of(devices, can);
  out << what << (any ? " (" + option + " NAME):" : ": none") << '\n';
  for (const auto& device : devices)
    if (device.*can)
      out << fmt::format("  {:<36} {}\n", device.name, device.description);
}

// The components of a role that this build has.
void list_role(const char* role, const std::string& what, std::ostream& out) {
  std::string lines;
  for (const auto& [description, create] : built_in_plugins())
    if (std::ranges::find(description.roles, role) != description.roles.end())
      lines +=
          fmt::format("  {:<36} {}\n", description.name, description.sentence);
  out << what << (lines.empty() ? ": none (docs/speech.md)" : ":") << '\n'
      << lines;
}

int list_all(const Console& console) {
  const auto devices = adapters::list_sound_devices();
  if (!devices) {
    say_error(console, to_string(devices.error()));
    return exit_code::wrong;
  }
  list(*devices, &SoundDevice::captures, "microphones", "--microphone",
       console.out);
  list(*devices, &SoundDevice::plays, "speakers", "--speaker", console.out);
  list_role("ASR", "recognisers", console.out);
  list_role("TTS", "voices", console.out);
  if (!devices->empty())
    return exit_code::success;
  say_error(console,
            "this machine has no sound device that ALSA knows; sound files can "
            "take their place: parlour run APP --voice --microphone FILE.wav "
            "--speaker FILE.wav");
  return exit_code::wrong;
}

// -- the test
// ------------------------------------------------------------------

std::string verdict(const LevelMeter& level) {
  if (level.peak() < no_sound)
    return "nothing was heard: is the microphone muted, or another one meant?";
  if (level.clipped() > much_clipped)
    return fmt::format("{:.1f} % of the sound is cut off: turn the microphone "
                       "down (alsamixer)",
                       level.clipped() * 100);
  if (level.peak() > loud_speech)
    return "that is loud; a little less would be safer";
  return "that is well if you have spoken; between words it should be 20 dB "
         "less";
}

int failed(const Console& console, const Error& error) {
  say_error(console, error.message);
  return exit_code::wrong;
}

int test_speaker(const std::string& device, const Console& console) {
  console.out << "speaker " << device << ": a tone of one second" << std::endl;
  const auto played = adapters::try_speaker(device, tone_time);
  return played ? exit_code::success : failed(console, played.error());
}

// On a terminal one line that is drawn again, otherwise a line each time.
void show(const LevelMeter& level, const Console& console) {
  const auto bar = "  " + level_bar(level);
  if (console.redraws)
    console.out << "\r\033[K" << bar << std::flush;
  else
    console.out << bar << std::endl;
}

int test_microphone(const std::string& device, Milliseconds time,
                    const Console& console) {
  console.out << "microphone " << device << ": speak for "
              << time.count() / 1'000 << " s" << std::endl;
  int count = 0;
  const auto heard =
      adapters::try_microphone(device, time, [&](const LevelMeter& level) {
        if (count++ % shown_each == 0)
          show(level, console);
      });
  if (console.redraws)
    console.out << "\r\033[K";
  if (!heard)
    return failed(console, heard.error());
  console.out << fmt::format("level {:.0f} dB, peak {:.0f} dB: ",
                             heard->level(), heard->peak())
              << verdict(*heard) << '\n';
  return heard->peak() < no_sound ? exit_code::wrong : exit_code::success;
}

} // namespace

int devices_command(const DevicesOptions& options, const Console& console) {
  if (!options.test)
    return status_of_printing(console, list_all(console));
  const auto speaker = test_speaker(options.speaker, console);
  const auto microphone =
      test_microphone(options.microphone, options.time, console);
  return status_of_printing(console, std::max(speaker, microphone));
}

} // namespace parlour::tools
