// AlsaSpeaker is a plug-in for the role Speaker: a device of ALSA, of any rate,
// number of channels and kind of samples. It understands and fires what
// FileSpeaker does. At most 40 ms of sound wait in the device, so that an
// utterance that is stopped is silent within 60 ms; played and Finished are
// about what was heard. Playing is fired when its sound goes to the device.
//
// A device that is gone for long: what is being played and what waits ends as
// interrupted, Failed(reason), and the component is not available until the
// device is back. A shorter outage delays what is played.
//
// Threads: events are fired by the stream's thread, too.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "adapters/audio/alsa/device_stream.hpp"
#include "adapters/audio/playout_speaker.hpp"
#include "adapters/audio/resampler.hpp"

namespace parlour::adapters {

class AlsaSpeaker : public PlayoutSpeaker, private StreamUser {
public:
  explicit AlsaSpeaker(StreamLimits limits = {});
  // Nothing calls it any more, also where nobody has stopped it.
  ~AlsaSpeaker() override;

  void stop() override;

protected:
  Expected<void> on_start(const Options& options) override;
  Expected<void> ready() override;
  void changed() override;

private:
  bool is_running() override;
  void begin(const PcmFormat& format) override;
  void fill(std::vector<Sample>& samples) override;
  void waiting(std::size_t samples) override;
  void add_playing(std::span<const Sample> samples,
                   std::optional<PlayoutEvent> event);
  void lost(const std::string& reason) override;
  void found() override;

  const StreamLimits limits_;
  std::unique_ptr<DeviceStream> stream_;

  std::optional<std::string> lost_; // why; under the playout's lock

  // The rest is for the stream's thread.
  PcmFormat format_;
  std::optional<Resampler> resampler_;
  std::uint64_t heard_ = 0;      // samples that the playout gave
  std::vector<Sample> sounding_; // the beginning of the next frame of Playing
  std::optional<PlayoutEvent> playing_; // of it, once something sounds in it
  Milliseconds silent_{0};              // since something sounded
};

// The limits are for tests.
PluginFactory alsa_speaker_factory(const StreamLimits& limits = {});

} // namespace parlour::adapters
