// FileMicrophone is a plug-in for the role Microphone that hears a file: WAV,
// FLAC and others, of any rate.
//
//  start_mic     Started, then BufferFull(audio, position) for each 20 ms;
//                position is that of the frame's beginning, in ms since
//                start_mic. After the file and the silence:
//                FileEnded(position).
//  stop_mic      Stopped; start_mic then goes on where it stopped, or begins
//                the file again after its end.
//  SetFormat     another rate and number of channels, while it is stopped
//
// Options: file (in the application's folder), pace, silence, loop. It lives by
// the host's delays, so in virtual time it takes no time.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "adapters/audio/pace.hpp"
#include "adapters/audio/sound_file_frames.hpp"
#include "runtime/plugin/adaptors.hpp"

namespace parlour::adapters {

class FileMicrophone : public MicrophonePlugin {
public:
  // `file` takes the place of the option, if it is not empty.
  explicit FileMicrophone(std::filesystem::path file = {});

  void stop() override;

protected:
  Expected<void> on_start(const Options& options) override;
  void on_start_mic() override;
  void on_stop_mic() override;
  void on_set_format(std::int64_t rate, std::int64_t channels) override;

private:
  Expected<void> open(const PcmFormat& format);
  void wait();
  void tick();
  void file_ended();
  void stop_ticking();

  std::filesystem::path file_;
  SoundFileFrames::Ending ending_;
  std::optional<Pace> pace_;
  std::optional<SoundFileFrames> frames_;
  PcmFormat format_;
  bool running_ = false;
  bool at_end_ = false;
  std::int64_t position_ = 0; // ms since it was started
  std::vector<Sample> frame_; // kept to be used again
  PluginHost::DelayId delay_ = 0;
};

// With a path, that file is heard, wherever it is, and the option is ignored:
// for a file that is named on the command line.
PluginFactory file_microphone_factory(const std::filesystem::path& file = {});

} // namespace parlour::adapters
