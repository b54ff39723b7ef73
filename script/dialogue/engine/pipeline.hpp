// Pipeline: the pipeline lane (engine rules 1d and 2). Gives a message to the
// active state's <Messages>, then to every matching handler in file order. A
// handler that waits holds only later messages of the same source and command;
// none where it waits for the user, and what the user says not where it waits
// for time (language rules 10.1 and 12.16).
#pragma once

#include <memory>
#include <vector>

#include "script/dialogue/agenda/step_list.hpp"
#include "script/dialogue/context/activation_runner.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/inbox.hpp"
#include "script/dialogue/context/input.hpp"
#include "script/dialogue/context/messenger.hpp"
#include "script/dialogue/context/reactions.hpp"
#include "script/dialogue/engine/answers.hpp"
#include "script/dialogue/engine/handled_message.hpp"
#include "script/dialogue/engine/message_end.hpp"
#include "script/dialogue/engine/state_machine.hpp"
#include "script/dialogue/engine/waits.hpp"
#include "script/dialogue/topic_engine/topic_engine.hpp"

namespace parlour::dialogue {

// Messages of one source and command that wait behind a handler that waits.
inline constexpr std::size_t max_held = 100;

class Pipeline {
public:
  Pipeline(DialogueContext& context, Messenger& messenger, Inbox& inbox,
           ActivationRunner& runner, RunningScript& running,
           const Reactions& reactions, TopicEngine& topics, Waits& waits,
           StateMachine& machine, Answers& answers, MessageEnd& message_end,
           HandledMessage& handled)
      : context_(context), messenger_(messenger), inbox_(inbox),
        runner_(runner), running_(running), reactions_(reactions),
        topics_(topics), waits_(waits), machine_(machine), answers_(answers),
        message_end_(message_end), handled_(handled) {}

  // Behind an activation that waits at most max_held wait; a further one
  // is an error and is dropped. What is an answer to one that waits for the
  // user goes straight to it (answers.hpp).
  void take(Input&& input);
  // An activation of this lane goes on; false where it is none of ours.
  bool resume(WaitId wait, Expected<Value> outcome);

  std::vector<WaitId> waits() const;
  bool waits(WaitId wait) const;

  template <class Archive>
  void serialize(Archive& archive) {
    archive.without(context_, messenger_, inbox_, runner_, running_, reactions_,
                    topics_, waits_, machine_, answers_, message_end_, handled_,
                    spare_);
    archive(waiting_);
  }

private:
  struct Item {
    std::shared_ptr<const Message> message;
    TurnId turn = 0;
    bool raised = false;
    std::vector<Reactions::Match> reactions;
    std::size_t next = 0;
    bool consumed = false;
    bool is_said = false;   // by the user
    bool overflows = false; // too much is behind it
    bool holds_turn = true;
    WaitId waiting = 0;
    WaitFor what = WaitFor::answer;
    std::vector<Input> behind; // same source and command

    template <class Archive>
    void serialize(Archive& archive) {
      archive(message, turn, raised, reactions, next, consumed, is_said,
              overflows, holds_turn, waiting, behind);
      archive.up_to(what, WaitFor::user);
      archive.needs(message);
      archive.check(waiting != 0 && next > 0 && next <= reactions.size(),
                    "no reaction to a message waits");
    }

    const Reactions::Match& running() const {
      return reactions[next - 1];
    }
  };

  void hold(Item& item, Input input);
  static bool holds(const Item& item, const Input& input);
  // The one that waits and that this message must wait for; null: none.
  Item* waits_before(const Input& input) const;
  // Whether a reaction that waits for the user would get the message, too.
  bool asks_again(const Item& item) const;
  void go_on(Item& item);
  void started(Item& item, WaitId wait);
  // What is handed over becomes an item of the dialogue lane, which ends with
  // the question that is then due.
  void hand_over(StepList steps, TurnId turn);
  void finish(Item& item);
  void keep(Item&& item); // until what it waits for comes
  void let_go_of_held(Item& item);
  static bool was_worded(const Item& item);

  DialogueContext& context_;
  Messenger& messenger_;
  Inbox& inbox_;
  ActivationRunner& runner_;
  RunningScript& running_;
  const Reactions& reactions_;
  TopicEngine& topics_;
  Waits& waits_;
  StateMachine& machine_;
  Answers& answers_;
  MessageEnd& message_end_;
  HandledMessage& handled_;
  std::vector<std::unique_ptr<Item>> waiting_;
  std::vector<Reactions::Match> spare_; // of an item that is over: its memory
};

} // namespace parlour::dialogue
