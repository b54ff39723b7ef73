#include "adapters/audio/file_speaker.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

#include "adapters/audio/file_options.hpp"

namespace parlour::adapters {

namespace {

const std::vector<OptionDescription>& option_descriptions() {
  static const std::vector<OptionDescription> options = {
      {"file", "speaker.wav",
       "the file, in the data folder; FLAC if it ends in .flac, else WAV"},
      {"rate", "16000", "samples a second in the file", false,
       OptionType::integer},
      pace_option("it plays"),
      {"silence", "0s",
       "the longest silence between utterances that is written, too", false,
       OptionType::duration}};
  return options;
}

} // namespace

FileSpeaker::FileSpeaker(std::filesystem::path file) : file_(std::move(file)) {}

Expected<void> FileSpeaker::on_start(const Options& given) {
  OptionReader read(given, option_descriptions());
  auto options = read_file_options(read, file_, host().data_folder());
  const auto rate = read.integer("rate", 8'000, 192'000);
  if (auto outcome = read.outcome(); !outcome)
    return outcome;
  file_ = std::move(options.file);
  pace_ = options.pace;
  silence_ = options.silence;
  return open(static_cast<int>(rate));
}

Expected<void> FileSpeaker::open(int rate) {
  std::error_code ignored;
  std::filesystem::create_directories(file_.parent_path(), ignored);
  auto resampler = Resampler::create({}, {rate, 1});
  if (!resampler)
    return tl::make_unexpected(resampler.error());
  resampler_ = std::move(*resampler);
  auto writer = SoundFileWriter::create(file_, {rate, 1});
  if (!writer)
    return tl::make_unexpected(writer.error());
  writer_ = std::move(*writer);
  return {};
}

void FileSpeaker::stop() {
  if (delay_ != 0)
    host().cancel(std::exchange(delay_, 0));
  if (!writer_)
    return;
  converted_.clear();
  resampler_->finish(converted_);
  (void)writer_->write(converted_);
  writer_.reset();
}

// -- sound
// ---------------------------------------------------------------------

// While nothing is there to play, no delay is set: a conversation in virtual
// time would wait for it.
void FileSpeaker::changed() {
  tell(with_playout(
      [](Playout& playout) { return playout.events(playout.pulled()); }));
  if (delay_ != 0 ||
      with_playout([](Playout& playout) { return playout.is_idle(); }))
    return;
  pace_->begin(host().clock().now());
  wait();
}

void FileSpeaker::wait() {
  delay_ =
      host().after(pace_->until_next(host().clock().now()), [this] { tick(); });
}

void FileSpeaker::tick() {
  delay_ = 0;
  const auto now = host().clock().now();
  while (writer_ && pace_->until_next(now) == Milliseconds::zero()) {
    if (!play_frame())
      return;
    pace_->next();
  }
  if (writer_)
    wait();
}

bool FileSpeaker::play_frame() {
  frame_.resize(frame_samples);
  const auto [events, sounding, goes_on] = with_playout([&](Playout& playout) {
    const auto sound = playout.pull(frame_) > 0;
    auto told = playout.events(playout.pulled());
    if (sound)
      told.push_back(playout.playing(frame_));
    return std::tuple(std::move(told), sound, !playout.is_idle());
  });
  if (sounding) {
    write_silence();
    write(frame_);
    silent_ = host().clock().now();
  }
  tell(events);
  return goes_on;
}

// The silence between two frames that follow each other is none: what is longer
// than a frame was silent.
void FileSpeaker::write_silence() {
  if (!silent_)
    return;
  const auto passed =
      pace_->sound_in(Milliseconds(host().clock().now() - *silent_));
  const auto frames =
      std::min(passed, silence_ + Milliseconds(frame_time)).count() /
          frame_time -
      1;
  const std::vector<Sample> silent(frame_samples);
  for (auto left = frames; left > 0 && writer_; --left)
    write(silent);
}

void FileSpeaker::write(std::span<const Sample> samples) {
  converted_.clear();
  resampler_->process(samples, converted_);
  if (auto written = writer_->write(converted_); !written) {
    writer_.reset();
    host().failed(to_string(written.error()));
  }
}

PluginFactory file_speaker_factory(const std::filesystem::path& file) {
  PluginDescription description;
  description.name = "FileSpeaker";
  description.roles = {"Speaker"};
  description.sentence = "writes to a file what would be heard";
  description.options = option_descriptions();
  return {std::move(description),
          [file] { return std::make_unique<FileSpeaker>(file); }};
}

} // namespace parlour::adapters
