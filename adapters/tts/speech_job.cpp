#include "adapters/tts/speech_job.hpp"

#include <iterator>
#include <limits>
#include <utility>

namespace parlour::adapters::tts {

namespace {

// So much more than is taken at a time may be ready before the next piece is
// begun.
constexpr Milliseconds in_store{3'000};

std::deque<Words> queue_of(std::vector<Words> pieces) {
  return {std::make_move_iterator(pieces.begin()),
          std::make_move_iterator(pieces.end())};
}

} // namespace

SpeechJob::SpeechJob(const std::string& text, const PieceLength& length,
                     VoiceSettings settings, Milliseconds ahead, Wake wake)
    : words_(speakable_words(text)), settings_(std::move(settings)),
      max_ready_(static_cast<std::size_t>((ahead + in_store).count()) /
                 frame_time),
      wake_(std::move(wake)), pieces_(queue_of(pieces_of(words_, length))),
      is_complete_(pieces_.empty()) {}

// -- the engine's side --------------------------------------------------------

bool SpeechJob::wants_more() const {
  const std::lock_guard lock(mutex_);
  return !cancelled_ && !is_complete_ && frames_.size() < max_ready_;
}

void SpeechJob::speak_next(Synthesizer& synthesizer) {
  std::unique_lock lock(mutex_);
  if (pieces_.empty() || cancelled_)
    return;
  const auto piece = std::move(pieces_.front());
  pieces_.pop_front();
  const bool is_last = pieces_.empty();
  lock.unlock();
  piece_words_ = piece.size();
  piece_start_ = duration(heard_, rate_);
  const auto outcome = synthesizer.speak(piece, is_last, settings_, *this);
  lock.lock();
  end_piece(outcome);
}

void SpeechJob::word(std::size_t index, std::int64_t position) {
  const std::lock_guard lock(mutex_);
  if (index < piece_words_)
    mark_before(piece_word_ + index + 1, piece_start_ + position);
}

// Words that the synthesizer passes over, such as a dash, begin with the next.
void SpeechJob::mark_before(std::size_t word, std::int64_t position) {
  for (; next_word_ < word; ++next_word_)
    marks_.push_back({words_[next_word_], position});
}

bool SpeechJob::sound(std::span<const Sample> samples, int rate) {
  if (cancelled_ || !prepare(rate))
    return false;
  heard_ += samples.size();
  resampler_->process(samples, part_);
  const std::lock_guard lock(mutex_);
  cut_frames();
  changed();
  return !cancelled_;
}

bool SpeechJob::prepare(int rate) {
  if (resampler_)
    return true;
  rate_ = rate;
  auto made = Resampler::create({rate, 1}, {});
  if (!made) {
    unusable_ = made.error().message;
    return false;
  }
  resampler_ = std::move(*made);
  return true;
}

void SpeechJob::cut_frames() {
  std::size_t used = 0;
  for (; part_.size() - used >= frame_samples; used += frame_samples)
    frames_.push_back(pcm_value(std::span(part_).subspan(used, frame_samples)));
  part_.erase(part_.begin(), part_.begin() + static_cast<std::ptrdiff_t>(used));
}

void SpeechJob::end_piece(const Expected<void>& outcome) {
  piece_word_ += piece_words_;
  mark_before(piece_word_, duration(heard_, rate_));
  trouble_ = outcome ? unusable_ : outcome.error().message;
  if (!trouble_.empty())
    pieces_.clear();
  if (pieces_.empty())
    finish();
  changed();
}

// The last frame is filled up with silence.
void SpeechJob::finish() {
  if (resampler_)
    resampler_->finish(part_);
  const auto frames = (part_.size() + frame_samples - 1) / frame_samples;
  part_.resize(frames * frame_samples);
  cut_frames();
  is_complete_ = true;
}

void SpeechJob::changed() {
  changed_.notify_all();
  if (!cancelled_ && std::exchange(hungry_, false))
    wake_();
}

// -- the plug-in's side -------------------------------------------------------

// Ready is only what is followed by more or is known to be the end: in virtual
// time a text that ends there must be over at once, however busy the machine
// is.
bool SpeechJob::is_ready(std::int64_t until) const {
  return is_complete_ || cancelled_ || frames_.size() >= max_ready_ ||
         taken_ + static_cast<std::int64_t>(frames_.size()) * frame_time >
             until;
}

// A word is told before the frame that it begins in.
Portion SpeechJob::take(std::int64_t until) {
  const std::lock_guard lock(mutex_);
  Portion portion;
  auto& spoken = portion.spoken;
  auto take_marks = [&](std::int64_t before) {
    for (; !marks_.empty() && marks_.front().position < before;
         marks_.pop_front())
      spoken.emplace_back(std::move(marks_.front()));
  };
  for (; !frames_.empty() && taken_ < until; frames_.pop_front()) {
    taken_ += frame_time;
    take_marks(taken_);
    spoken.emplace_back(std::move(frames_.front()));
  }
  portion.is_over = is_complete_ && frames_.empty();
  if (portion.is_over)
    take_marks(std::numeric_limits<std::int64_t>::max());
  portion.trouble = trouble_;
  portion.will_wake = hungry_ = !is_ready(until);
  return portion;
}

void SpeechJob::await(std::int64_t until) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return is_ready(until); });
}

void SpeechJob::cancel() {
  const std::lock_guard lock(mutex_);
  cancelled_ = true;
  changed_.notify_all();
}

} // namespace parlour::adapters::tts
