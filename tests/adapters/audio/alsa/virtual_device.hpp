// VirtualDevice: a folder with a configuration for alsa-lib that has devices of
// tests/adapters/audio/vdev, and what they capture and have played.
#pragma once

#include <cstdlib>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "adapters/audio/alsa/device_samples.hpp"
#include "adapters/audio/alsa/device_stream.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::test {

struct VirtualDeviceOptions {
  int rate = adapters::speech_rate;
  int channels = 1;
  std::string format = "S16_LE";
  double speed = 10;
  std::string faults = {}; // "xrun@8000 unplug@16000"
};

class VirtualDevice {
public:
  // The device is called "dev" in both directions.
  explicit VirtualDevice(const VirtualDeviceOptions& options = {}) {
    const auto library =
        std::filesystem::path(program_path()).parent_path().parent_path() /
        "lib/vdev.so";
    folder_.write(
        "asound.conf",
        fmt::format("pcm_type.vdev {{ lib \"{}\" }}\n"
                    "pcm.dev {{ type vdev file \"{}\" gone \"{}\" blocked "
                    "\"{}\" rate \"{}\" channels \"{}\" format \"{}\" speed "
                    "\"{}\" faults \"{}\" hint {{ show on description \"A "
                    "device for tests\nthat is virtual\" }} }}\n"
                    "pcm.null {{ type null hint {{ show on }} }}\n",
                    library.string(), path("sound"), path("gone"),
                    path("blocked"), options.rate, options.channels,
                    options.format, options.speed, options.faults));
    setenv("ALSA_CONFIG_PATH", path("asound.conf").c_str(), 1);
  }

  std::string path(const std::string& name) const {
    return (folder_.path() / name).string();
  }
  bool is_gone() const {
    return folder_.has("gone");
  }
  void plug_in() const {
    std::filesystem::remove(path("gone"));
  }
  void block() const {
    folder_.write("blocked", "");
  }
  void unblock() const {
    std::filesystem::remove(path("blocked"));
  }

  // What it captures: each sample on all channels.
  void captures(const std::vector<adapters::Sample>& samples,
                adapters::DeviceSamples kind = adapters::DeviceSamples::s16,
                int channels = 1) const {
    std::vector<adapters::Sample> all;
    for (const auto sample : samples)
      all.insert(all.end(), static_cast<std::size_t>(channels), sample);
    std::vector<std::byte> bytes;
    adapters::append_bytes(kind, all, bytes);
    folder_.write("sound",
                  {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  }
  // What it has played, of all channels.
  std::vector<adapters::Sample>
  played(adapters::DeviceSamples kind = adapters::DeviceSamples::s16) const {
    const auto text = folder_.read("sound");
    std::vector<adapters::Sample> samples;
    adapters::append_samples(
        kind, std::as_bytes(std::span(text.data(), text.size())), samples);
    return samples;
  }

  // For a device that is ten times faster than the clock.
  static adapters::StreamLimits limits() {
    adapters::StreamLimits limits;
    limits.recovery.open_pause = Milliseconds(5);
    limits.recovery.longest_open_pause = Milliseconds(20);
    limits.recovery.report_after = Milliseconds(60);
    limits.recovery.stable_after = Milliseconds(60);
    limits.hang = Milliseconds(200);
    limits.fastest = 100;
    return limits;
  }

private:
  TemporaryFolder folder_;
};

} // namespace parlour::test
