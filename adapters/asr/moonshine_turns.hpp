// The turns of all conversations that are being spoken or recognised. Pure
// bookkeeping; not thread-safe.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "adapters/asr/moonshine_frames.hpp"
#include "runtime/message/message.hpp"

namespace parlour::adapters::moonshine {

// MoonshineASR calls it under its mutex.
class MoonshineTurns {
public:
  static constexpr std::size_t max_spoken = 64;   // turns
  static constexpr std::size_t max_finished = 64; // turns
  static constexpr std::size_t max_samples = std::size_t{30} * speech_rate;

  // Known by its number until its result is there.
  struct Turn {
    // The first piece, or Finish when that has come: what answers belong to.
    Message order;
    std::size_t samples = 0;
    std::int64_t revision = 0;
    bool is_finished = false;
  };

  // Where a piece of audio belongs.
  struct Place {
    TurnNumber turn = 0;
    bool is_new = false;
    std::size_t samples = 0; // how many of them are still heard
    // A turn that gives way to this one, as too many are being spoken.
    std::optional<TurnNumber> dropped;
  };
  // Begins a turn if the session has none.
  Place add(const Message& audio, std::size_t samples);

  // The turn that ends, or nothing if the session has none.
  std::optional<TurnNumber> finish(const Message& order);
  bool has_room() const {
    return finished_ < max_finished;
  }

  // The session's turns are over. The second list has the orders to finish that
  // wait.
  struct Cancelled {
    std::vector<TurnNumber> turns;
    std::vector<Message> orders;
  };
  Cancelled cancel(const SessionId& session);

  // The order of a turn's partial result, and the result's revision.
  struct Partial {
    Message order;
    std::int64_t revision = 0;
  };
  std::optional<Partial> partial(TurnNumber turn);
  // Forgets a finished turn.
  std::optional<Message> take(TurnNumber turn);
  // Forgets all; the orders to finish that wait.
  std::vector<Message> take_all();

private:
  // Nothing while there is room.
  std::optional<TurnNumber> drop_one();
  void erase(std::map<TurnNumber, Turn>::iterator turn);

  TurnNumber last_ = 0;
  std::size_t finished_ = 0;
  std::map<TurnNumber, Turn> turns_;
  std::map<SessionId, TurnNumber> spoken_;
};

} // namespace parlour::adapters::moonshine
