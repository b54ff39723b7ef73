#include "adapters/audio/sound_file_frames.hpp"

#include <algorithm>
#include <utility>

namespace parlour::adapters {

namespace {

constexpr std::size_t block = 4'096; // samples of each channel

std::size_t samples(Milliseconds time, const PcmFormat& format) {
  return static_cast<std::size_t>(time.count() * format.rate / 1'000) *
         static_cast<std::size_t>(format.channels);
}

} // namespace

Expected<SoundFileFrames>
SoundFileFrames::open(const std::filesystem::path& path,
                      const PcmFormat& format, const Ending& ending) {
  auto reader = SoundFileReader::open(path);
  if (!reader)
    return tl::make_unexpected(reader.error());
  auto resampler = Resampler::create(reader->format(), format);
  if (!resampler)
    return tl::make_unexpected(resampler.error());
  return SoundFileFrames(std::move(*reader), std::move(*resampler), format,
                         ending);
}

SoundFileFrames::SoundFileFrames(SoundFileReader reader, Resampler resampler,
                                 const PcmFormat& format, const Ending& ending)
    : reader_(std::move(reader)), resampler_(std::move(resampler)),
      format_(format), ending_(ending),
      frame_size_(samples(Milliseconds(frame_time), format)) {
  read_.resize(block * static_cast<std::size_t>(reader_.format().channels));
  begin();
}

void SoundFileFrames::begin() {
  at_end_ = false;
  has_sound_ = false;
  silence_left_ = samples(ending_.silence, format_);
}

void SoundFileFrames::rewind() {
  std::vector<Sample> dropped;
  resampler_.finish(dropped);
  ready_.clear();
  used_ = 0;
  reader_.rewind();
  begin();
}

bool SoundFileFrames::next(std::vector<Sample>& frame) {
  while (ready_.size() - used_ < frame_size_)
    if (!read_more())
      break;
  const auto count = std::min(frame_size_, ready_.size() - used_);
  const auto first = ready_.begin() + static_cast<std::ptrdiff_t>(used_);
  frame.assign(first, first + static_cast<std::ptrdiff_t>(count));
  frame.resize(frame_size_);
  used_ += count;
  return count > 0;
}

bool SoundFileFrames::read_more() {
  ready_.erase(ready_.begin(),
               ready_.begin() + static_cast<std::ptrdiff_t>(used_));
  used_ = 0;
  if (at_end_)
    return end_of_file();
  const auto count = reader_.read(read_);
  if (count > 0) {
    resampler_.process(std::span(read_).first(count), ready_);
  } else {
    resampler_.finish(ready_);
    at_end_ = true;
  }
  has_sound_ = has_sound_ || count > 0;
  return true;
}

// A file without sound would be begun again and again.
bool SoundFileFrames::end_of_file() {
  const auto count = std::min(silence_left_, frame_size_);
  if (count > 0) {
    ready_.resize(ready_.size() + count);
    silence_left_ -= count;
    return true;
  }
  if (!ending_.loop || !has_sound_)
    return false;
  reader_.rewind();
  begin();
  return true;
}

} // namespace parlour::adapters
