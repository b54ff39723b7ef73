// HeldEffects: what a session wants of others, kept back until the journal has
// what led to it (engine rule 7.11). Without a strict journal nothing is kept
// back. Lives on the session's thread.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "actors/protocol/in_flight.hpp"

namespace parlour::actors {

// An example: the user says "yes, transfer it", and the script posts Transfer.
// The post waits here until the record with the "yes" is on the disk; a crash
// before that has neither.
class HeldEffects {
public:
  // Whether somebody must know, after a crash, that it was done.
  enum class Noted : bool { no, yes };

  explicit HeldEffects(bool holds) : holds_(holds) {}

  bool holds() const {
    return holds_;
  }
  bool none() const {
    return effects_.empty();
  }

  // Does it now, or keeps it back; `work` is held meanwhile.
  template <class Effect>
  void perform(Effect effect, InFlight work = {}, Noted noted = Noted::no) {
    if (!holds_)
      return effect();
    effects_.push_back({0, 0, noted, std::move(effect), std::move(work)});
  }

  // What was kept back since the last call waits for this record, which has the
  // session's input of that number. False where nothing was.
  // Records are numbered from 1 by the journal, inputs by the session.
  bool wait_for(std::uint64_t record, std::uint64_t input);
  // This record and all before it are written: does what waited for them.
  // Returned is the last input of which something must be noted as done.
  // Nothing where nobody has to know.
  std::optional<std::uint64_t> written(std::uint64_t record);

private:
  // `input` is that of the session which led to it; both are 0 until the record
  // is known.
  struct Held {
    std::uint64_t record; // 0: not known yet
    std::uint64_t input;
    Noted noted;
    std::function<void()> effect;
    InFlight work;
  };

  const bool holds_;
  std::vector<Held> effects_;
};

} // namespace parlour::actors
