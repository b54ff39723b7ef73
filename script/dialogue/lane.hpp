// Lane: the dialogue lane (engine rule 2). Items run one at a time, each as an
// agenda of steps. An agenda that waits gets a context above it: for the steps
// that its script handed over, and, where it waits for the user (confirm, a
// pushed state), for the next items too. Any other wait holds the lane.
#pragma once

#include <cstddef>
#include <vector>

#include "script/dialogue/fifo.hpp"
#include "script/dialogue/step.hpp"

namespace parlour::dialogue {

class Lane {
public:
  // Behind everything that is queued: acts and events.
  void queue(std::vector<Step> item);
  // The same; what is given is empty then and keeps its memory.
  void queue_from(std::vector<Step>& item);
  // In front of all that runs, in the given order; above a context that waits.
  void now(std::vector<Step> steps);
  void now_from(std::vector<Step>& steps);
  void at_once(Step&& step);

  // An empty list of steps with the memory of one that is over.
  std::vector<Step> blank();

  // The next step to take, where it lies until the next call; null while the
  // lane waits or is idle.
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
  // Steps in their order; a step stays where it is while it is taken.
  struct Agenda {
    std::vector<Step> steps;
    std::size_t taken = 0;

    bool over() const {
      return taken == steps.size();
    }
  };
  struct Context {
    std::vector<Agenda> agendas; // the one in front last
    WaitId waiting = 0;
    bool for_user = false;

    bool has_steps() const;
  };

  bool at_rest() const; // what is queued would be taken at once
  static void put_in_front(std::vector<Step>&& steps, Context& context);
  void keep_memory(std::vector<Step>&& steps);
  Step* take_from(Context& context); // null: it has none
  Context& running();                // above one that waits
  void part_with_acts(Context& context);

  std::vector<Context> contexts_{1};
  Fifo<std::vector<Step>> queue_;
  std::vector<Context> abandoned_; // the step that is being taken lies there
  std::vector<std::vector<Step>> blanks_;
  bool running_ = false; // a step was given out, and there may be others
};

} // namespace parlour::dialogue
