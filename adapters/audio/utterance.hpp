// What a speaker knows of one utterance: its audio, where its words begin, and
// how much of it has gone out.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "adapters/audio/pcm.hpp"
#include "runtime/message/message.hpp"

namespace parlour::adapters {

// For one thread at a time. Audio is shared with the messages that brought it,
// not copied.
class Utterance {
public:
  // How long it takes to become silent when it is stopped.
  static constexpr std::size_t fade_samples = speech_rate * 20 / 1'000;

  Utterance(Message order, std::int64_t id);

  bool is(const SessionId& session, std::int64_t id) const {
    return order_.session == session && id_ == id;
  }
  std::int64_t id() const {
    return id_;
  }
  // The message that asked for it first; the one that finishes it, once there
  // is one.
  const Message& order() const {
    return order_;
  }

  // `samples` are those of the value.
  void append(const Value& audio, std::span<const Sample> samples);
  // The word begins at this position in ms.
  void mark(std::string word, std::int64_t position);
  // No more audio comes.
  void finish(Message order);
  // What follows fades, then it is over.
  void stop();

  bool is_finished() const {
    return finished_;
  }
  bool is_stopped() const {
    return fade_left_.has_value();
  }
  // Nothing of it goes out any more.
  bool is_over() const;
  // Samples that may go out.
  std::size_t waiting() const {
    return waiting_;
  }
  // Samples that have gone out.
  std::size_t taken() const {
    return taken_;
  }
  std::size_t mark_count() const {
    return marks_.size();
  }
  std::size_t piece_count() const {
    return pieces_.size();
  }

  // Moves the next samples to `out`; returns how many there were.
  std::size_t take(std::span<Sample> out);

  // The words that were spoken to their end if so many samples were heard;
  // unknown if nobody has said where words begin.
  Value spoken_text(std::size_t heard) const;

private:
  struct Piece {
    Value audio; // keeps the samples
    std::span<const Sample> rest;
  };
  struct Mark {
    std::string word;
    std::int64_t position;
  };

  void fade(std::span<Sample> samples);

  Message order_;
  std::int64_t id_;
  std::deque<Piece> pieces_;
  std::vector<Mark> marks_; // in the order of their positions
  std::size_t waiting_ = 0;
  std::size_t taken_ = 0;
  bool finished_ = false;
  std::optional<std::size_t> fade_left_; // once it is stopped
};

} // namespace parlour::adapters
