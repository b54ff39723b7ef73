// SoundFileFrames cuts a file into frames of 20 ms, as a microphone would bring
// them.
#pragma once

#include <filesystem>
#include <vector>

#include "adapters/audio/resampler.hpp"
#include "adapters/audio/sound_file.hpp"
#include "runtime/base/clock.hpp"

namespace parlour::adapters {

// For one thread at a time. Reads a little of the file at a time.
class SoundFileFrames {
public:
  struct Ending {
    Milliseconds silence{0}; // that follows the file
    bool loop = false;       // the file comes again after it
  };

  // Errors are those of SoundFileReader and Resampler.
  static Expected<SoundFileFrames> open(const std::filesystem::path& path,
                                        const PcmFormat& format,
                                        const Ending& ending);

  // Replaces `frame` by the next 20 ms; the last one ends in silence. False at
  // the end.
  bool next(std::vector<Sample>& frame);
  // The next frame is the first one again.
  void rewind();

private:
  SoundFileFrames(SoundFileReader reader, Resampler resampler,
                  const PcmFormat& format, const Ending& ending);

  // Makes more samples ready; false at the end.
  bool read_more();
  bool end_of_file();
  void begin();

  SoundFileReader reader_;
  Resampler resampler_;
  PcmFormat format_;
  Ending ending_;
  std::size_t frame_size_;    // samples of all channels
  std::vector<Sample> read_;  // kept to be used again
  std::vector<Sample> ready_; // from used_ on
  std::size_t used_ = 0;
  std::size_t silence_left_ = 0; // samples of all channels
  bool at_end_ = false;          // of the file, not of the silence
  bool has_sound_ = false;       // since the file began
};

} // namespace parlour::adapters
