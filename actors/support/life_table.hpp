// LifeTable: a table of transitions that says what becomes of something at each
// event, and what is to be done then. Pure data: who uses it carries the deeds
// out. A pair of a state and an event that cannot come together has a row, too,
// without a next state. No thread, no actor, no time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>

namespace parlour::actors {

// What a transition asks for, in this order.
template <class Deed>
class Deeds {
public:
  // The longest row has as many; a row with more does not compile.
  static constexpr std::size_t max = 4;

  constexpr Deeds() = default;
  // More than `max` do not compile in a constant table.
  constexpr Deeds(std::initializer_list<Deed> deeds) {
    for (auto deed : deeds)
      all_.at(count_++) = deed;
  }
  constexpr const Deed* begin() const {
    return all_.data();
  }
  constexpr const Deed* end() const {
    return all_.data() + count_;
  }

private:
  std::array<Deed, max> all_ = {};
  std::size_t count_ = 0;
};

template <class State, class Event, class Deed>
struct LifeRow {
  State state;
  Event event;
  std::optional<State> next; // nothing: the two never come together
  Deeds<Deed> deeds = {};
};

// All rows by state, then by event, as the two enumerations count them.
// A lookup is one multiplication; the order of the rows makes up for the
// search.
template <class Row, std::size_t states, std::size_t events>
struct LifeTable {
  std::array<Row, states * events> rows;

  // Whether each pair has its one row, and that where it is looked up.
  constexpr bool is_complete() const {
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (static_cast<std::size_t>(rows[i].state) != i / events ||
          static_cast<std::size_t>(rows[i].event) != i % events)
        return false;
    return true;
  }
  template <class State, class Event>
  constexpr const Row& at(State state, Event event) const {
    return rows[static_cast<std::size_t>(state) * events +
                static_cast<std::size_t>(event)];
  }
};

} // namespace parlour::actors
