// Lane: the dialogue lane (engine rule 2). Items run one at a time, each as an
// agenda of steps. An agenda that waits gets a context above it: for the steps
// that its script handed over, and, where it waits for the user (confirm, a
// pushed state), for the next items too. Any other wait holds the lane.
#pragma once

#include <vector>

#include "script/dialogue/fifo.hpp"
#include "script/dialogue/step_list.hpp"

namespace parlour::dialogue {

class Lane {
public:
  // Behind everything that is queued: acts and events.
  void queue(StepList item);
  // In front of all that runs, in the given order; above a context that waits.
  void now(StepList steps);
  void at_once(Step&& step);

  // The next step to take, which stays where it is until the next call; null
  // while the lane waits or is idle.
  Step* next();

  // The running context waits; `for_user` lets further items be taken, and
  // what else its utterance said before them.
  void wait(WaitId wait, bool for_user);
  // Ends that wait: `step` is taken when the contexts above it are done.
  // False where nothing waits so.
  bool wake(WaitId wait, Step step);
  // Ends all waits; the agendas of all contexts are dropped, the queued items
  // stay. Returns the waits, innermost first.
  std::vector<WaitId> abandon();
  // Drops the queued items.
  void clear();

  bool idle() const; // nothing to take, except for waits for the user
  bool held() const; // something waits that is not for the user
  bool waits_for_user() const;
  bool waits(WaitId wait) const;
  // The context below goes on when the running one is done.
  bool returning() const;

private:
  struct Context {
    StepList agenda;
    WaitId waiting = 0;
    bool for_user = false;
  };

  bool at_rest() const; // what is queued would be taken at once
  Context& running();   // above one that waits
  void part_with_acts(Context& context);

  std::vector<Context> contexts_{1};
  Fifo<StepList> queue_;
  StepList::Taken taken_;
  bool running_ = false; // a step was given out, and there may be others
};

} // namespace parlour::dialogue
