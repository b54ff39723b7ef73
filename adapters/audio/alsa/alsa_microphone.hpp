// AlsaMicrophone is a plug-in for the role Microphone: a device of ALSA, of any
// rate, number of channels and kind of samples.
//
//  start_mic     Started, then BufferFull(audio, position) for each 20 ms;
//                position is that of the frame's beginning, in ms since
//                start_mic. Where the device failed for a moment, it jumps by
//                the time that nothing was captured.
//  stop_mic      Stopped; the device is closed
//  SetFormat     another rate and number of channels, while it is stopped
//
// A device that is gone for long: Failed(reason), and the component is not
// available until the device is back; then it goes on.
//
// Threads: BufferFull and Failed are fired by the stream's thread.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "adapters/audio/alsa/device_stream.hpp"
#include "adapters/audio/resampler.hpp"
#include "runtime/plugin/adaptors.hpp"

namespace parlour::adapters {

class AlsaMicrophone : public MicrophonePlugin, private StreamUser {
public:
  explicit AlsaMicrophone(StreamLimits limits = {});
  // Nothing calls it any more, also where nobody has stopped it.
  ~AlsaMicrophone() override;

  void stop() override;

protected:
  Expected<void> on_start(const Options& options) override;
  void on_start_mic() override;
  void on_stop_mic() override;
  void on_set_format(std::int64_t rate, std::int64_t channels) override;

private:
  bool is_running() override;
  void begin(const PcmFormat& format) override;
  void captured(std::span<const Sample> samples, Milliseconds lost) override;
  void lost(const std::string& reason) override;
  void found() override;

  void make_resampler();
  void fire_frames();

  const StreamLimits limits_;
  std::unique_ptr<DeviceStream> stream_;

  std::mutex mutex_; // for all that follows
  bool wanted_ = false;
  std::optional<std::string> lost_; // why
  PcmFormat format_;                // of the frames
  std::int64_t position_ = 0;       // ms since it was started
  PcmFormat device_format_;         // of the device that was open last
  std::optional<Resampler> resampler_;
  std::vector<Sample> ready_;
};

// The limits are for tests.
PluginFactory alsa_microphone_factory(const StreamLimits& limits = {});

} // namespace parlour::adapters
