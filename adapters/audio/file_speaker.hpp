// FileSpeaker is a plug-in for the role Speaker that writes to a file what
// would be heard, WAV or FLAC, and takes the time that it would take.
//
//  Play(audio, utterance)            Started(utterance) when it begins to
//  sound;
//                                    Playing(audio, position) for each 20 ms;
//                                    position in ms of the utterance's audio
//  Mark(utterance, word, position)
//  Finish(utterance)                 Finished(utterance, played, interrupted,
//                                    spoken_text) once all was played
//  Stop(utterance?)                  fades; then Finished with interrupted: of
//                                    one utterance, or of all of the session
//
// spoken_text has the words whose end was heard; it is unknown without marks.
//
// Options: file (in the data folder), rate, pace, silence. It lives by the
// host's delays, so in virtual time it takes no time.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "adapters/audio/pace.hpp"
#include "adapters/audio/playout_speaker.hpp"
#include "adapters/audio/resampler.hpp"
#include "adapters/audio/sound_file.hpp"

namespace parlour::adapters {

class FileSpeaker : public PlayoutSpeaker {
public:
  // `file` takes the place of the option, if it is not empty.
  explicit FileSpeaker(std::filesystem::path file = {});

  // What has not been played is not written.
  void stop() override;

protected:
  Expected<void> on_start(const Options& options) override;
  void changed() override;

private:
  Expected<void> open(int rate);
  void wait();
  void tick();
  // Plays 20 ms; false once there is nothing left to play.
  bool play_frame();
  void write_silence();
  void write(std::span<const Sample> samples);

  std::filesystem::path file_;
  std::optional<Pace> pace_;
  std::optional<SoundFileWriter> writer_;
  std::optional<Resampler> resampler_;
  Milliseconds silence_{0};         // the longest that is written
  std::optional<Timestamp> silent_; // since when; once there was sound
  std::vector<Sample> frame_;       // these two are kept to be used again
  std::vector<Sample> converted_;
  PluginHost::DelayId delay_ = 0;
};

// With a path, that file is written, wherever it is, and the option is ignored:
// for a file that is named on the command line.
PluginFactory file_speaker_factory(const std::filesystem::path& file = {});

} // namespace parlour::adapters
