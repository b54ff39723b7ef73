// Timers: what a session waits for by the clock. The actor that rings only
// knows an id; what it means is kept here, as plain data. Who owns them is the
// conversation; each wait for time, each deadline and the silence that it
// watches is one of these, so that a saved conversation knows all of them by
// the times when they are due.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "script/dialogue/agenda/port.hpp"
#include "script/dialogue/agenda/step.hpp"
#include "script/support/short_lived.hpp"

namespace parlour::dialogue {

// What one id means. Each purpose uses only some of the fields; the others stay
// empty.
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
  // In milliseconds since 1970; the port rings at once where it is over.
  Timestamp due = 0;
  // Of a <timer>.
  std::string name{};
  Milliseconds every{0};   // 0: it rings once
  bool keeps_open = false; // no session closes while it is due
  VisitId visit = 0;       // of the state that it ends with; 0: none
  CodeId code = script::no_code;
  std::vector<Value> arguments{};
  std::size_t bytes = 0; // that the arguments take
  TopicId topic = script::no_id;
  // Of the others.
  WaitId wait = 0;
  // Of a <request> and the like: what was asked, so that its ringing is a
  // time-out and no end of a <wait>; 0: it is a <wait>. Of purpose `wording`:
  // the Generate that NLG does not answer.
  Correlation correlation = 0;

  template <class Archive>
  void serialize(Archive& archive) {
    archive.up_to(purpose, Purpose::leaving);
    archive(due, name, every, keeps_open, visit, arguments, bytes, wait,
            correlation);
    archive.code(code);
    archive.topic(topic);
    if (purpose == Purpose::script)
      archive.needs(code);
  }
};

// Owned by ConversationImplementation. No call does anything to scripts: who
// calls fired() acts on what it returns.
class Timers {
public:
  explicit Timers(Port& port) : port_(&port) {}

  // Starts it with the port as well, and returns its id.
  TimerId start(Timestamp due, Timer timer);
  TimerId start(Timestamp due, Timer::Purpose purpose); // and no more
  // Another port is to ring, at the same times (engine rule 7.9).
  void resume();
  void cancel(TimerId id);
  // Scripts' ones of that name, rung ones included whose statements have not
  // run yet (language rule 10.3).
  void cancel_named(const std::string& name);
  // The deadline of a wait that was answered or given up.
  void cancel_wait(WaitId wait);
  // Scripts' ones that end with a visit of a state that is over.
  template <class IsOver>
  void end_with(IsOver is_over) {
    stop_scripts([&](const auto& timer) {
      return timer.visit != 0 && is_over(timer.visit);
    });
  }
  // Those of another conversation, under their ids and at the same times, as
  // far as `keeps` can change them; the port is told of the others only. Those
  // that it has lost.
  template <class Keeps>
  std::vector<Timer> take_over(const Timers& before, Keeps keeps) {
    std::vector<Timer> lost;
    last_ = before.last_;
    for (auto [id, timer] : before.timers_)
      if (keeps(timer)) {
        timers_.emplace_back(id, std::move(timer));
      } else {
        port_->cancel_timer(id);
        lost.push_back(std::move(timer));
      }
    return lost;
  }
  // Takes a fired timer out; a repeating one starts again from `now`. Nothing
  // where it was cancelled meanwhile.
  std::optional<Timer> fired(TimerId id, Timestamp now);
  // The session is over.
  void cancel_all();
  bool any(Timer::Purpose purpose) const;
  // Whether a session must not close yet.
  bool keep_open() const;

  // One of a script has rung: its statements are to run, unless it is stopped
  // before. Null where the last time's are not done yet.
  std::shared_ptr<Ring> ring(const Timer& timer);

  std::vector<const Timer*> pending() const; // scripts' ones
  // Why one more of a script, a <timer> or <wait>, after those there are, is
  // too much (language rule 9.6). `limit` is in bytes, of what all of them
  // remember. Nothing: it may be started.
  std::optional<Error> refuse(const Timer& timer, std::size_t limit) const;

  template <class Archive>
  void serialize(Archive& archive) {
    archive.without(port_);
    archive(timers_, last_);
    auto rings = ringing(); // those of steps, which come later
    archive(rings);
    for (const auto& ring : rings)
      archive.needs(ring);
    rings_.assign(rings.begin(), rings.end());
  }

private:
  void ring_at(TimerId id, const Timer& timer);
  template <class Predicate>
  void cancel_where(Predicate predicate) {
    std::erase_if(timers_, [&](const auto& entry) {
      if (!predicate(entry.second))
        return false;
      port_->cancel_timer(entry.first);
      return true;
    });
  }
  template <class Predicate>
  void stop_scripts(Predicate predicate) {
    cancel_where([&](const Timer& timer) {
      return timer.purpose == Timer::Purpose::script && predicate(timer);
    });
    for (const auto& known : rings_)
      if (const auto ring = known.lock())
        ring->stopped |= predicate(*ring);
  }

  using Entry = std::pair<TimerId, Timer>;
  using Entries = ShortLivedList<Entry>;

  Entries::iterator find(TimerId id);
  std::vector<std::shared_ptr<Ring>> ringing() const;

  Entries timers_;                         // by id
  std::vector<std::weak_ptr<Ring>> rings_; // of scripts' ones
  Port* port_;
  TimerId last_ = 0;
};

} // namespace parlour::dialogue
