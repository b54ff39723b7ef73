// Endpointing: decides which audio is a user's turn, and when the turn has
// ended. A detector says where speech starts and ends; a turn is more than
// that: it begins a little before the speech, goes on over pauses, and how long
// a pause may be depends on what was recognised so far.
//
//   Endpointing endpointing({});
//   endpointing.speech_started(1'200);
//   for (auto& step : endpointing.hear(frame, 1'240))
//     ...
//
// Time is the position in the audio, in milliseconds, so that a stream that is
// played faster gives the same turns. What is kept is bounded by the times of
// EndpointTimes. Not thread-safe.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <variant>
#include <vector>

#include "runtime/base/clock.hpp"
#include "runtime/base/value.hpp"

namespace parlour::adapters {

// All in milliseconds.
struct EndpointTimes {
  // How much silence ends a turn: after a whole sentence, after what may be
  // one, and where a sentence cannot end.
  Milliseconds after_sentence{300};
  Milliseconds usual{700};
  Milliseconds within_sentence{1'200};
  // How long somebody must speak before that interrupts the robot.
  Milliseconds interruption{250};
  // How much audio before and after the speech belongs to the turn.
  Milliseconds margin{300};
  // Longer turns are cut.
  Milliseconds longest{30'000};
  // It is asleep until it is woken, and falls asleep after so much silence of
  // everybody. Nothing: always awake.
  std::optional<Milliseconds> awake = {};
};

// What follows from what was heard. Positions in milliseconds.
struct TurnStarted {
  std::int64_t position = 0; // of the first speech
};
struct TurnAudio {
  Value frame;
};
struct TurnEnded {
  std::int64_t position = 0; // of the last speech
};
struct TurnDropped {
  std::int64_t position = 0; // of the last frame
};
struct Woken {
  std::int64_t position = 0; // of the last frame
};
struct FellAsleep {
  std::int64_t position = 0; // of the last frame
};
using TurnStep = std::variant<TurnStarted, TurnAudio, TurnEnded, TurnDropped,
                              Woken, FellAsleep>;
using TurnSteps = std::vector<TurnStep>;

class Endpointing {
public:
  explicit Endpointing(EndpointTimes times)
      : times_(times), is_asleep_(times.awake), told_asleep_(is_asleep_) {}

  // The next frame, which begins at this position.
  TurnSteps hear(Value frame, std::int64_t position);

  // What the detector says, which may be some frames late.
  void speech_started(std::int64_t position);
  void speech_ended(std::int64_t position);
  // What the recogniser has made of the turn: a whole sentence, or one that
  // cannot end there; nothing: it does not know.
  void recognised(std::optional<bool> ends);
  // While the robot speaks, a short sound is no turn.
  void robot_speaks(bool speaks);

  // Its name was said, up to this position, or just now: what is said from
  // there on is a turn. While it is asleep, nothing else is.
  void wake(std::optional<std::int64_t> position);
  void sleep();

  // No more audio comes: a turn ends as it is.
  TurnSteps finish();
  // Forgets what was heard, and drops the turn that is open: positions begin
  // anew. Who is awake stays so for as long as if woken now.
  TurnSteps reset();

  bool in_turn() const {
    return turn_.has_value();
  }
  bool is_asleep() const {
    return is_asleep_;
  }

private:
  struct Frame {
    Value audio;
    std::int64_t position = 0;
  };
  struct Turn {
    std::int64_t start = 0; // of the speech
    std::int64_t from = 0;  // of the audio that belongs to it
    std::optional<bool> ends = {};
  };

  bool is_turn() const;
  // Falls asleep if it is time, and tells of a change.
  void rest(TurnSteps& steps);
  // How much is kept of what may become a turn.
  std::int64_t kept_time() const;
  bool is_over() const;
  Milliseconds pause() const;
  void begin(TurnSteps& steps);
  // Hands over what is kept, up to a position.
  void pass(TurnSteps& steps, std::int64_t until);
  void end(TurnSteps& steps);
  void forget_old_frames();

  EndpointTimes times_;
  std::deque<Frame> kept_;
  std::int64_t now_ = 0; // where the last frame began
  bool robot_speaks_ = false;
  // Of the speech that the detector told of last; nothing: there was none, or
  // it has been dealt with.
  std::optional<std::int64_t> speech_start_;
  std::optional<std::int64_t> speech_end_;
  std::optional<Turn> turn_;
  bool is_asleep_ = false;
  bool told_asleep_ = false;
  // Where somebody spoke last, while it is awake.
  std::int64_t active_at_ = 0;
  // The speech may be no more than the rest of the word that woke it.
  bool follows_word_ = false;
};

} // namespace parlour::adapters
