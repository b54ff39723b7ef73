#include "adapters/audio/file_microphone.hpp"

#include <utility>

#include "adapters/audio/file_options.hpp"

namespace parlour::adapters {

namespace {

const std::vector<OptionDescription>& option_descriptions() {
  static const std::vector<OptionDescription> options = {
      {"file", "", "the file that is heard, in the application's folder"},
      pace_option("it is heard"),
      {"silence", "2s", "how much silence follows the file", false,
       OptionType::duration},
      {"loop", "false", "whether the file begins again after that", false,
       OptionType::boolean}};
  return options;
}

} // namespace

FileMicrophone::FileMicrophone(std::filesystem::path file)
    : file_(std::move(file)) {}

Expected<void> FileMicrophone::on_start(const Options& given) {
  OptionReader read(given, option_descriptions());
  auto options = read_file_options(read, file_, host().application_folder());
  if (options.file.empty())
    read.wrong("file", "says which file is heard, such as visitor.wav");
  if (auto outcome = read.outcome(); !outcome)
    return outcome;
  file_ = std::move(options.file);
  pace_ = options.pace;
  ending_ = {options.silence, read.truth("loop")};
  return open({});
}

Expected<void> FileMicrophone::open(const PcmFormat& format) {
  auto frames = SoundFileFrames::open(file_, format, ending_);
  if (!frames)
    return tl::make_unexpected(frames.error());
  frames_ = std::move(*frames);
  format_ = format;
  at_end_ = false;
  return {};
}

void FileMicrophone::stop() {
  stop_ticking();
  frames_.reset();
}

void FileMicrophone::stop_ticking() {
  running_ = false;
  if (delay_ != 0)
    host().cancel(std::exchange(delay_, 0));
}

// -- commands
// ------------------------------------------------------------------

void FileMicrophone::on_start_mic() {
  fire_started();
  if (std::exchange(running_, true))
    return;
  if (std::exchange(at_end_, false))
    frames_->rewind();
  position_ = 0;
  pace_->begin(host().clock().now());
  wait();
}

void FileMicrophone::on_stop_mic() {
  stop_ticking();
  fire_stopped();
}

void FileMicrophone::on_set_format(std::int64_t rate, std::int64_t channels) {
  if (running_)
    return refuse("the format can be set while the microphone is stopped");
  if (rate < 8'000 || rate > 48'000 || channels < 1 || channels > 2)
    return refuse("a rate from 8000 to 48000 and 1 or 2 channels can be had");
  if (auto opened = open({static_cast<int>(rate), static_cast<int>(channels)});
      !opened)
    refuse(to_string(opened.error()));
}

// -- sound
// ---------------------------------------------------------------------

void FileMicrophone::wait() {
  delay_ =
      host().after(pace_->until_next(host().clock().now()), [this] { tick(); });
}

// Usually one frame is due; more if the thread was busy.
void FileMicrophone::tick() {
  delay_ = 0;
  const auto now = host().clock().now();
  while (pace_->until_next(now) == Milliseconds::zero()) {
    if (!frames_->next(frame_))
      return file_ended();
    answer({}, "BufferFull", {pcm_value(frame_, format_), position_});
    position_ += frame_time;
    pace_->next();
  }
  wait();
}

void FileMicrophone::file_ended() {
  running_ = false;
  at_end_ = true;
  answer({}, "FileEnded", {position_});
}

PluginFactory file_microphone_factory(const std::filesystem::path& file) {
  PluginDescription description;
  description.name = "FileMicrophone";
  description.roles = {"Microphone"};
  description.sentence = "hears a sound file";
  description.options = option_descriptions();
  description.events = {{"FileEnded", "position"}};
  return {std::move(description),
          [file] { return std::make_unique<FileMicrophone>(file); }};
}

} // namespace parlour::adapters
