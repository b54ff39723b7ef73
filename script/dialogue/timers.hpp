// Timers: what a session waits for by the clock. The actor that rings only
// knows an id; what it means is kept here, as plain data.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "script/dialogue/port.hpp"
#include "script/dialogue/short_lived.hpp"
#include "script/dialogue/step.hpp"

namespace parlour::dialogue {

struct Timer {
  // clang-format off
  enum class Purpose : std::uint8_t {
    script,   // a <timer>
    wait,     // a <wait>, or the deadline of a <request>
    wording,  // the NLG component's time
    silence,  // nobody says anything
    patience, // a component does not answer; then the turn is over
    closing,  // the session's last
    leaving,  // the last that Exit and Session.Ended may wait for
  };
  // clang-format on
  Purpose purpose = Purpose::script;
  std::string name{};
  Milliseconds every{0}; // of a repeating <timer>; 0: once
  CodeId code = script::no_code;
  std::vector<Value> arguments{};
  std::size_t bytes = 0; // that the arguments of a <timer> take
  TopicId topic = script::no_id;
  WaitId wait = 0;
  Correlation correlation = 0;
};

class Timers {
public:
  explicit Timers(Port& port) : port_(&port) {}

  TimerId start(Milliseconds after, Timer timer);
  TimerId start(Milliseconds after, Timer::Purpose purpose); // and no more
  void cancel(TimerId id);
  void cancel_named(const std::string& name); // scripts' ones
  void cancel_wait(WaitId wait);
  // Takes a fired timer out; a repeating one starts again. Nothing where it
  // was cancelled meanwhile.
  std::optional<Timer> fired(TimerId id);
  void cancel_all();
  bool any(Timer::Purpose purpose) const;
  // Why one more of a script, after those there are, is too much (language
  // rule 9.6).
  std::optional<Error> refuse(const Timer& timer, std::size_t limit) const;

private:
  template <class Predicate>
  void cancel_where(Predicate predicate);

  using Entry = std::pair<TimerId, Timer>;
  using Entries = ShortLivedList<Entry>;

  Entries::iterator find(TimerId id);

  Entries timers_; // by id
  Port* port_;
  TimerId last_ = 0;
};

} // namespace parlour::dialogue
