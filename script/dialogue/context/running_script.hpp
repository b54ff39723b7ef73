// RunningScript: the piece of script that runs, as the statements in it see it:
// where it stands, what it waits for from now on, the steps that it asks for,
// and what it has done. Who starts and resumes it is the ActivationRunner,
// which no statement needs to know. No statement starts another piece: it asks
// for a step, which is taken later, so there is only one to know.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "script/dialogue/agenda/step_list.hpp"
#include "script/dialogue/context/messenger.hpp"

namespace parlour::dialogue {

// What the effect that suspends an activation waits for.
enum class WaitFor : std::uint8_t {
  answer, // of a component or a database; its slice, too
  time,   // <wait>
  user,   // <confirm>, <push>
};

// What begin_wait has noted; an id of 0: it does not wait.
struct Wait {
  WaitId id = 0;
  WaitFor what = WaitFor::answer;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(id);
    archive.up_to(what, WaitFor::user);
  }
};

// Bodies of which something is known: few, and asked for with each that starts,
// so a list without order is quicker than a set.
class Bodies {
public:
  void insert(CodeId body) {
    if ((all_.empty() || all_.back() != body) && !contains(body))
      all_.push_back(body);
  }
  void erase(CodeId body) {
    std::erase(all_, body);
  }
  bool contains(CodeId body) const {
    return std::find(all_.begin(), all_.end(), body) != all_.end();
  }

  template <class Archive>
  void serialize(Archive& archive) {
    std::sort(all_.begin(), all_.end()); // equal ones have equal bytes
    archive.codes(all_);
  }

private:
  std::vector<CodeId> all_; // in no order; keeps its memory
};

// Owned by ConversationImplementation. What it knows of bodies (whether one has
// redirected or acted) outlives their activations: the topic engine asks for it
// when the activation has ended.
class RunningScript {
public:
  RunningScript(DialogueContext& context, Messenger& messenger)
      : context_(context), messenger_(messenger) {}

  // -- what its statements do --
  // That it waits from now on, for what comes with that id. The effect that
  // calls it returns Waits.
  WaitId begin_wait(WaitFor what);
  // A step that they ask for; taken when it ends or waits.
  template <class Kind>
  void later(Kind&& kind) {
    later_.add(std::forward<Kind>(kind));
  }
  // Its clear, ask or transit: the body leads elsewhere than to its end. A
  // topic whose <filled> did so is not completed by its end (engine rule 5.4).
  void redirect() {
    redirect(body_);
  }
  void redirect(CodeId body) {
    redirected_.insert(body);
  }
  // It has done something that cannot be taken back, or was heard: a topic
  // whose <completed> has acted is done (engine rule 5.8).
  void acts() {
    acted_.insert(body_);
    ++deeds_;
  }

  // -- what is known of it, and of those that have run --
  // What was started: the body of which the running statement is a part.
  CodeId body() const {
    return body_;
  }
  // Where it stands.
  const Origin& origin() const {
    return origin_;
  }
  // Whether the body did so, when it ran last.
  bool redirected(CodeId body) const {
    return redirected_.contains(body);
  }
  bool acted(CodeId body) const {
    return acted_.contains(body);
  }
  std::uint64_t deeds() const { // of all that have run
    return deeds_;
  }

  // -- for who runs it --
  // This body is about to run.
  void begins(CodeId body, Origin origin);
  // One that waited is about to go on, with what it had asked for.
  void goes_on(CodeId body, Origin origin, StepList later);
  // What it waits for now, if it does.
  Wait take_wait() {
    return std::exchange(wait_, {});
  }
  // It has asked to leave the state that it is of: what goes on behind its own
  // <transit> or <pop> does not end with that.
  bool leaves_its_state() const;
  // What it asked for so far.
  StepList take_later() {
    return std::exchange(later_, {});
  }
  // The same, when it has ended or waits. Each is an internal event (engine
  // rule 2.6); those beyond the limit are dropped. Acts hold their turn until
  // they are taken.
  StepList hand_over() {
    return later_.empty() ? StepList() : take_over();
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive.without(context_, messenger_);
    archive.code(body_);
    archive(wait_, origin_, later_, redirected_, acted_, deeds_);
  }

private:
  StepList take_over();
  void drop(const Step& step);

  DialogueContext& context_;
  Messenger& messenger_;
  CodeId body_ = script::no_code;
  Wait wait_;
  Origin origin_;
  StepList later_;
  Bodies redirected_;
  Bodies acted_;
  std::uint64_t deeds_ = 0;
};

} // namespace parlour::dialogue
