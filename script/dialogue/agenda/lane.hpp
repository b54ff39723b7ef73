// Lane: the dialogue lane (engine rule 2). Items run one at a time, each as an
// agenda of steps. An agenda that waits gets a context above it: for the steps
// that its script handed over, and, where it waits for the user (confirm, a
// pushed state) or for time, for the next items too. Any other wait holds the
// lane, also for what has waited; else that goes on as soon as the running one
// ends or waits.
//
// For example, a topic's <completed> asks by <confirm>, and the visitor says
// "is there a lift?". The context of the <completed> waits; the question about
// the lift runs to its end in a context above. When the yes comes, the
// <completed> goes on where it stopped.
//
// Plain data of one conversation. The lane runs nothing:
// ConversationImplementation::run_lane takes the steps out, and the parts that
// carry them out call the lane again.
#pragma once

#include <cstdint>
#include <vector>

#include "script/dialogue/agenda/step_list.hpp"
#include "script/support/fifo.hpp"

namespace parlour::dialogue {

// Owned by the DialogueContext. The lane knows a wait by its id alone; the
// activation that waits is with the ActivationRunner.
class Lane {
public:
  // Behind everything that is queued: acts and events. An empty item is
  // ignored.
  void queue(StepList item);
  // In front of all that runs, in the given order; above a context that waits.
  // What a later call hands over runs before what an earlier one did.
  void now(StepList steps);
  template <class Kind>
  void at_once(Kind&& kind) {
    now(StepList(std::forward<Kind>(kind)));
  }

  // The next step to take, which stays where it is until the next call; null
  // while the lane waits or is idle.
  Step* next();

  // Whether further items are taken meanwhile, and before them what else the
  // utterance said. A query holds them, as the next item may depend on its
  // result. A <confirm> lets them go on, as its answer is one of them.
  enum class Others : std::uint8_t { are_held, go_on };
  // The running context waits.
  void wait(WaitId wait, Others others);
  // Ends that wait: `steps` are taken when the running context ends or waits;
  // others that wait for the user do not hold it. False where nothing waits so.
  // The context moves above those which only wait for the user or for time, and
  // no further.
  bool wake(WaitId wait, StepList steps);
  // What comes when that wait is over and its activation has ended, unless its
  // agenda settles with that topic already: a topic that is filled while its
  // <confirm> waits is settled once, after the answer.
  void follow(WaitId wait, steps::Settle&& step);
  // Removes the context that waits so, and returns what its agenda still had to
  // do. The activation is not ended by that: the caller tells it.
  StepList take_out(WaitId wait);
  // Ends all waits but these; the agendas of all other contexts are dropped,
  // the queued items stay. Returns the waits, innermost first, whose
  // activations the caller has to end (Waits::cancel).
  std::vector<WaitId> abandon(const std::vector<WaitId>& but = {});
  // Drops the queued items.
  void clear();

  // Nothing to take, and nothing holds it. A context that waits for the user
  // leaves the lane idle: silence may count then.
  bool idle() const;
  // Something waits that holds the others: until that is over no further item
  // is taken, and nothing that was woken goes on.
  bool held() const;
  bool waits() const;
  bool waits(WaitId wait) const;
  // Another context goes on when the running one is done. The running one need
  // not ask what is due then: that one concludes.
  bool returning() const;

  // What the running item has still to do, such as the further acts of the same
  // utterance: "yes, and cancel the other one".
  const StepList& ahead() const {
    return contexts_.back().agenda;
  }
  // What else the user said becomes an item of its own, the next. A yes is
  // followed up first, then the cancel that was said with it.
  void set_acts_aside() {
    part_with_acts(contexts_.back());
  }
  // The same, taken out: an item for the caller to queue. Empty where the user
  // said nothing else.
  StepList take_acts();
  // Takes out of it what `wanted` says. The user turns that acts hold are the
  // caller's to let go.
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
  // One agenda that runs or waits. The last context of the list is on top: it
  // is the only one that steps are taken from.
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
  static StepList acts_of(Context& context);

  // Never empty.
  Contexts contexts_{1};
  Fifo<StepList> queue_;
  // The step that next() has given out: the lane keeps it alive while it is
  // carried out.
  StepList::Taken taken_;
  // A step was given out, and there may be others. An item that is queued
  // meanwhile must not become the agenda of the item that runs, so
  // takes_at_once() looks at it.
  bool running_ = false;
};

} // namespace parlour::dialogue
