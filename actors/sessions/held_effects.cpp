#include "actors/sessions/held_effects.hpp"

#include <algorithm>
#include <iterator>

namespace parlour::actors {

// Those without a record are the last ones: effects are kept in order.
bool HeldEffects::wait_for(std::uint64_t record, std::uint64_t input) {
  bool waits = false;
  for (auto held = effects_.rbegin();
       held != effects_.rend() && held->record == 0; ++held) {
    held->record = record;
    held->input = input;
    waits = true;
  }
  return waits;
}

// An effect may keep back another one, which waits for a later record.
std::optional<std::uint64_t> HeldEffects::written(std::uint64_t record) {
  const auto end = std::ranges::find_if(effects_, [record](const Held& held) {
    return held.record == 0 || held.record > record;
  });
  std::vector<Held> due(std::make_move_iterator(effects_.begin()),
                        std::make_move_iterator(end));
  effects_.erase(effects_.begin(), end);
  std::optional<std::uint64_t> noted;
  for (auto& held : due) {
    held.effect();
    if (held.noted == Noted::yes)
      noted = held.input;
  }
  return noted;
}

} // namespace parlour::actors
