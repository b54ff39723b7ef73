// Lane: the dialogue lane (engine rule 2). Items run one at a time, each as an
// agenda of steps. An agenda that waits gets a context above it: for the steps
// that its script handed over, and, where it waits for the user (confirm, a
// pushed state) or for time, for the next items too. Any other wait holds the
// lane, also for what has waited; else that goes on as soon as the running one
// ends or waits.
#pragma once

#include <cstdint>
#include <vector>

#include "script/dialogue/agenda/step_list.hpp"
#include "script/support/fifo.hpp"

namespace parlour::dialogue {

class Lane {
public:
  // Behind everything that is queued: acts and events.
  void queue(StepList item);
  // In front of all that runs, in the given order; above a context that waits.
  void now(StepList steps);
  template <class Kind>
  void at_once(Kind&& kind) {
    now(StepList(std::forward<Kind>(kind)));
  }

  // The next step to take, which stays where it is until the next call; null
  // while the lane waits or is idle.
  Step* next();

  // Whether further items are taken meanwhile, and before them what else the
  // utterance said.
  enum class Others : std::uint8_t { are_held, go_on };
  // The running context waits.
  void wait(WaitId wait, Others others);
  // Ends that wait: `steps` are taken when the running context ends or waits;
  // others that wait for the user do not hold it. False where nothing waits so.
  bool wake(WaitId wait, StepList steps);
  // What comes when that wait is over and its activation has ended, unless its
  // agenda settles with that topic already.
  void follow(WaitId wait, steps::Settle&& step);
  // Ends that wait; what its agenda still had to do is for the caller.
  StepList take_out(WaitId wait);
  // Ends all waits but these; the agendas of all other contexts are dropped,
  // the queued items stay. Returns the waits, innermost first.
  std::vector<WaitId> abandon(const std::vector<WaitId>& but = {});
  // Drops the queued items.
  void clear();

  bool idle() const; // nothing to take, and nothing holds it
  bool held() const; // something waits that holds the others
  bool waits() const;
  bool waits(WaitId wait) const;
  // Another context goes on when the running one is done.
  bool returning() const;

  // What the running item has still to do.
  const StepList& ahead() const {
    return contexts_.back().agenda;
  }
  // What else the user said becomes an item of its own, the next.
  void set_acts_aside() {
    part_with_acts(contexts_.back());
  }
  // Takes out of it what `wanted` says.
  template <class Predicate>
  StepList take_ahead(Predicate wanted) {
    return contexts_.back().agenda.take_if(wanted);
  }
  // The same, of all that comes when waits are over.
  template <class Predicate>
  StepList take_waiting(Predicate wanted) {
    StepList taken;
    for (auto& context : contexts_)
      if (context.waiting != 0)
        taken.append(context.agenda.take_if(wanted));
    return taken;
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive.without(taken_);
    archive(contexts_, queue_, running_);
    archive.check(!contexts_.empty(), "the lane has no context");
  }

private:
  struct Context {
    StepList agenda;
    WaitId waiting = 0;
    Others others = Others::are_held;

    template <class Archive>
    void serialize(Archive& archive) {
      archive(agenda, waiting);
      archive.up_to(others, Others::go_on);
    }

    bool waits_so(WaitId wait) const {
      return waiting != 0 && waiting == wait;
    }
    bool can_run() const {
      return waiting == 0 && !agenda.empty();
    }
  };

  using Contexts = std::vector<Context>;

  Contexts::iterator waiting_so(WaitId wait); // the end: none
  bool takes_at_once() const;                 // what is queued
  bool bring_up_next();
  bool bring_up_woken();
  Context& running(); // above one that waits
  void part_with_acts(Context& context);

  Contexts contexts_{1};
  Fifo<StepList> queue_;
  StepList::Taken taken_;
  bool running_ = false; // a step was given out, and there may be others
};

} // namespace parlour::dialogue
