// SpeechJob is one text between the thread that synthesizes and the plug-in
// that delivers: the pieces that are still to be spoken, and the frames and
// words that are ready.
#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "adapters/audio/resampler.hpp"
#include "adapters/tts/synthesizer.hpp"
#include "runtime/base/clock.hpp"
#include "runtime/base/value.hpp"

namespace parlour::adapters::tts {

// A word of the text begins at this position, in ms of the whole audio.
struct SpokenWord {
  std::string word;
  std::int64_t position = 0;
};
// A word, or a frame of audio (pcm.hpp).
using Spoken = std::variant<SpokenWord, Value>;

struct Portion {
  std::vector<Spoken> spoken; // in order
  // Nothing follows: all has been taken, or the synthesizer has failed.
  bool is_over = false;
  std::string trouble; // why it has failed; empty: it has not
  // Not all that was asked for was ready; `wake` will be called.
  bool will_wake = false;
};

// Thread-safe. The engine's thread calls speak_next(), the plug-in's the rest.
class SpeechJob final : public SpeechSink {
public:
  // `wake` is called once, on the engine's thread with a lock held, when more
  // of a portion that was not ready may be taken. It is not called once
  // cancel() has returned.
  using Wake = std::function<void()>;

  // `ahead` is how much is taken at a time at most.
  SpeechJob(const std::string& text, const PieceLength& length,
            VoiceSettings settings, Milliseconds ahead, Wake wake);

  // Whether speak_next() has something to do: there is text left, and not too
  // much is ready already.
  bool wants_more() const;
  // Synthesizes the next piece.
  void speak_next(Synthesizer& synthesizer);

  // Takes what lies before the position, in ms.
  Portion take(std::int64_t until);
  // Blocks until all before the position is ready, or as much as may be.
  void await(std::int64_t until);
  // Whoever synthesizes stops soon, and nothing becomes ready any more.
  void cancel();

  void word(std::size_t index, std::int64_t position) override;
  bool sound(std::span<const Sample> samples, int rate) override;
  bool is_wanted() const override {
    return !cancelled_;
  }

private:
  // The mutex is held when these are called.
  bool is_ready(std::int64_t until) const;
  void mark_before(std::size_t word, std::int64_t position);
  void cut_frames();
  void end_piece(const Expected<void>& outcome);
  void finish();
  void changed();

  // False: nothing can be made of sound with this rate.
  bool prepare(int rate);

  const Words words_;
  const VoiceSettings settings_;
  const std::size_t max_ready_; // frames
  const Wake wake_;
  std::atomic<bool> cancelled_ = false;

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Words> pieces_; // that were not begun
  std::deque<SpokenWord> marks_;
  std::deque<Value> frames_;
  std::int64_t taken_ = 0; // ms of the frames that were taken
  bool is_complete_ = false;
  bool hungry_ = false; // a portion was not ready
  std::string trouble_;

  // Of the engine's thread alone.
  std::optional<Resampler> resampler_;
  std::vector<Sample> part_;     // less than a frame
  std::size_t piece_word_ = 0;   // the first word of the piece
  std::size_t piece_words_ = 0;  // how many it has
  std::size_t next_word_ = 0;    // the first word without a position
  std::size_t heard_ = 0;        // samples before resampling
  std::string unusable_;         // why the sound is of no use
  std::int64_t piece_start_ = 0; // ms
  int rate_ = speech_rate;
};

} // namespace parlour::adapters::tts
