// ActivationRunner: starts pieces of script, keeps those that wait, and hands
// outcomes back to them. An error that no <catch> took becomes the event
// Script.Error (language rule 12.19).
//
// It is given the Host that carries out the effects of scripts, so whatever it
// runs may come back to nearly every part of the conversation. None of those
// parts may need the runner: they are given the RunningScript, and
// TextEvaluator where they compute a text or a condition.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "script/dialogue/agenda/step_list.hpp"
#include "script/dialogue/agenda/timers.hpp"
#include "script/dialogue/context/messenger.hpp"
#include "script/dialogue/context/running_script.hpp"
#include "script/program/host.hpp"
#include "script/support/fifo.hpp"
#include "script/vm/interpreter.hpp"

namespace parlour::dialogue {

// One for each conversation, owned by ConversationImplementation and called in
// the session's turn. It knows the activations that wait, not where they wait:
// an activation of the dialogue lane has a context there (Lane), one of the
// pipeline lane an item (Pipeline), under the same WaitId.
class ActivationRunner {
public:
  ActivationRunner(DialogueContext& context, script::Interpreter& interpreter,
                   Messenger& messenger, Timers& timers, RunningScript& running,
                   script::Host& host)
      : context_(context), interpreter_(interpreter), messenger_(messenger),
        timers_(timers), running_(running), host_(host) {}

  // What became of an activation that ran until it ended or waits. Steps that
  // the activation has handed over are not in it (RunningScript::hand_over).
  struct Ran {
    WaitId wait = 0; // for which it waits; 0: it has ended,
    // and of which topic it was, where no <catch> took its error.
    TopicId failed = script::no_id;
  };
  // The steps that it asked for are then taken from the RunningScript. `origin`
  // says which state's visit or which timer the body belongs to.
  Ran start(CodeId code, const std::vector<Value>& arguments,
            script::ActivationContext context, Origin origin = {});
  // Goes on with an activation that waits: its effect gives the script this
  // value, or throws this error there. A deadline of the wait is cancelled.
  // Nothing happens where nothing waits so.
  Ran resume(WaitId wait, Expected<Value> outcome);

  // Whether an activation, in either lane, waits so.
  bool waiting(WaitId wait) const {
    return waiting_.count(wait) > 0;
  }
  // `answer` where nothing waits so.
  WaitFor waits_for(WaitId wait) const;
  // The user turn that the activation which waits works for.
  TurnId turn_of(WaitId wait) const;
  // Others that wait for the user in the same statements, outside of topics.
  std::vector<WaitId> asked_before(WaitId wait) const;
  // Waits for the user, or for time, of scripts whose state was left; each is
  // told once. The caller ends them as cancelled (engine rule 4.7).
  std::vector<WaitId> take_those_of_left_states();
  // Whether a <wait> of a topic's script goes on.
  bool topic_waits() const;
  bool anything_waits() const {
    return !waiting_.empty();
  }
  // Whether anything waits that is not for the user. The end of a session waits
  // for these.
  bool waits_for_others() const;

  // A wait whose activation only used up its slice (engine rule 2.7); 0: there
  // is none. It is to be resumed with any value, which the script does not see.
  WaitId take_slice();
  bool has_slices() const {
    return !slices_.empty();
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive.without(context_, interpreter_, messenger_, timers_, running_,
                    host_);
    archive(waiting_, slices_);
  }

private:
  // An activation that is suspended, with what the engine has to know to go on
  // with it.
  struct Waiting {
    std::unique_ptr<script::Activation> activation;
    // The body that was started, of which the activation may run a function.
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

  // Keeps an activation that waits or has yielded, and reports one that failed.
  Ran dispose(std::unique_ptr<script::Activation> activation,
              const script::RunResult& result);
  // Whether it is a fault of the script.
  bool report(const script::ActivationContext& context,
              const script::RunResult& result);

  DialogueContext& context_;
  script::Interpreter& interpreter_;
  Messenger& messenger_;
  Timers& timers_;
  RunningScript& running_;
  script::Host& host_;
  std::map<WaitId, Waiting> waiting_;
  Fifo<WaitId> slices_;
};

} // namespace parlour::dialogue
