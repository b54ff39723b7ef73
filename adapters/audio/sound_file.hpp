// Sound in files, by libsndfile: WAV, FLAC and what else it reads.
//
// For one thread at a time. Errors are of kind File and have the file as their
// place; of kind Settings where the program was built without the library.
#pragma once

#include <filesystem>
#include <memory>
#include <span>

#include "adapters/audio/pcm.hpp"

namespace parlour::adapters {

class SoundFileReader {
public:
  // Refuses what is no sound, what is no regular file, and formats that
  // parse_format() would refuse.
  static Expected<SoundFileReader> open(const std::filesystem::path& path);
  SoundFileReader(SoundFileReader&&) noexcept;
  SoundFileReader& operator=(SoundFileReader&&) noexcept;
  ~SoundFileReader();

  const PcmFormat& format() const;
  // Reads whole frames of all channels; returns the number of samples, which is
  // 0 at the end of the file, and where the rest of it cannot be read. Samples
  // of other kinds are converted to 16 bit.
  std::size_t read(std::span<Sample> samples);
  // The next samples are the first ones again.
  void rewind();

private:
  struct State;
  explicit SoundFileReader(std::unique_ptr<State> state);

  std::unique_ptr<State> state_;
};

class SoundFileWriter {
public:
  // Makes a file anew, FLAC if its name ends so, else WAV, with 16 bit. While
  // another writer has it, "name-2.wav" and so on take its place. The folder
  // must exist.
  static Expected<SoundFileWriter> create(const std::filesystem::path& path,
                                          const PcmFormat& format);
  SoundFileWriter(SoundFileWriter&&) noexcept;
  SoundFileWriter& operator=(SoundFileWriter&&) noexcept;
  // Completes the file.
  ~SoundFileWriter();

  // What it is really called.
  const std::filesystem::path& path() const;
  // Appends whole frames of all channels. A WAV file can be read whenever this
  // has returned. A file has at most 2 GB.
  Expected<void> write(std::span<const Sample> samples);

private:
  struct State;
  explicit SoundFileWriter(std::unique_ptr<State> state);

  std::unique_ptr<State> state_;
};

} // namespace parlour::adapters
