// ActivationRunner: starts pieces of script, keeps those that wait, and hands
// outcomes back to them. An error that no <catch> took becomes the event
// Script.Error (language rule 12.19).
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "script/dialogue/agenda/step_list.hpp"
#include "script/dialogue/agenda/timers.hpp"
#include "script/dialogue/context/messenger.hpp"
#include "script/program/host.hpp"
#include "script/support/fifo.hpp"
#include "script/vm/interpreter.hpp"

namespace parlour::dialogue {

// Bodies of which something is known: few, and asked for with each that starts.
class Bodies {
public:
  void insert(CodeId body) {
    if (!contains(body))
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

class ActivationRunner {
public:
  ActivationRunner(DialogueContext& context, script::Interpreter& interpreter,
                   Messenger& messenger, Timers& timers, script::Host& host)
      : context_(context), interpreter_(interpreter), messenger_(messenger),
        timers_(timers), host_(host) {}

  // What the effect that suspends the running activation waits for.
  enum class WaitFor : std::uint8_t {
    answer, // of a component or a database; its slice, too
    time,   // <wait>
    user,   // <confirm>, <push>
  };
  struct Wait {
    WaitId id = 0;
    WaitFor what = WaitFor::answer;

    template <class Archive>
    void serialize(Archive& archive) {
      archive(id);
      archive.up_to(what, WaitFor::user);
    }
  };
  // That it waits from now on, for what comes with that id.
  WaitId begin_wait(WaitFor what);

  // What became of an activation that ran until it ended or waits.
  struct Ran {
    WaitId wait = 0; // for which it waits; 0: it has ended,
    // and of which topic it was, where no <catch> took its error.
    TopicId failed = script::no_id;
  };
  // The steps that it asked for are then taken with hand_over().
  Ran start(CodeId code, const std::vector<Value>& arguments,
            script::ActivationContext context, Origin origin = {});
  Ran resume(WaitId wait, Expected<Value> outcome);

  // A step that the running activation's statements asked for; taken when it
  // ends or waits.
  template <class Kind>
  void later(Kind&& kind) {
    later_.add(std::forward<Kind>(kind));
  }

  bool waiting(WaitId wait) const {
    return waiting_.count(wait) > 0;
  }
  WaitFor waits_for(WaitId wait) const;
  // The user turn that the activation which waits works for.
  TurnId turn_of(WaitId wait) const;
  // Where the running activation stands.
  const Origin& origin() const {
    return origin_;
  }
  // Others that wait for the user in the same statements, outside of topics.
  std::vector<WaitId> asked_before(WaitId wait) const;
  // Waits for the user, or for time, of scripts whose state was left; each is
  // told once.
  std::vector<WaitId> take_those_of_left_states();
  // Whether a <wait> of a topic's script goes on.
  bool topic_waits() const;
  // Whether anything waits that is not for the user.
  bool waits_for_others() const;

  // What was started: the body of which the running statement is a part.
  CodeId body() const {
    return code_;
  }
  // Its clear, ask or transit: the body leads elsewhere than to its end.
  void redirect() {
    redirect(code_);
  }
  void redirect(CodeId body) {
    redirected_.insert(body);
  }
  // Whether it did, when it ran last.
  bool redirected(CodeId body) const {
    return redirected_.contains(body);
  }

  // It has done something that cannot be taken back, or was heard.
  void acts() {
    acted_.insert(code_);
    ++deeds_;
  }
  // Whether the body did, when it ran last.
  bool acted(CodeId body) const {
    return acted_.contains(body);
  }
  std::uint64_t deeds() const { // of all that have run
    return deeds_;
  }

  // A wait whose activation only used up its slice; 0: there is none.
  WaitId take_slice();
  bool has_slices() const {
    return !slices_.empty();
  }

  // Runs a short body that must not wait.
  Expected<Value> evaluate(CodeId code, const std::vector<Value>& arguments,
                           TopicId topic);
  // The same of a condition; one that fails does not hold, and is told.
  bool holds(CodeId condition, const std::vector<Value>& arguments,
             TopicId topic, TurnId turn);

  // What the statements of the activation that ended or waits asked for. Each
  // is an internal event (engine rule 2); acts hold their turn until taken.
  StepList hand_over();

  template <class Archive>
  void serialize(Archive& archive) {
    archive.without(context_, interpreter_, messenger_, timers_, host_);
    archive(expected_, origin_, later_, redirected_, acted_, deeds_, waiting_,
            slices_);
    archive.code(code_);
  }

private:
  struct Waiting {
    std::unique_ptr<script::Activation> activation;
    CodeId code = script::no_code;
    WaitFor what = WaitFor::answer;
    Origin origin;
    bool yielded = false; // its slice was used up; it waits for nothing
    StepList later;       // what it asked for so far, where it yielded

    template <class Archive>
    void serialize(Archive& archive) {
      archive.activation(activation);
      archive.code(code);
      archive.up_to(what, WaitFor::user);
      archive(origin, yielded, later);
    }
  };

  Ran dispose(std::unique_ptr<script::Activation> activation,
              const script::RunResult& result);
  bool leaves_its_state() const;
  // Whether it is a fault of the script.
  bool report(const script::ActivationContext& context,
              const script::RunResult& result);
  void drop(const Step& step);

  DialogueContext& context_;
  script::Interpreter& interpreter_;
  Messenger& messenger_;
  Timers& timers_;
  script::Host& host_;
  Wait expected_;
  CodeId code_ = script::no_code; // that runs
  Origin origin_;
  StepList later_;
  Bodies redirected_;
  Bodies acted_;
  std::uint64_t deeds_ = 0;
  std::map<WaitId, Waiting> waiting_;
  Fifo<WaitId> slices_;
};

} // namespace parlour::dialogue
