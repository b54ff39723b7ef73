// Pipeline: the pipeline lane (engine rules 1d and 2). Gives a message to the
// active state's <Messages>, then to every matching handler in file order. A
// handler that waits holds only later messages of the same source and command;
// none where it waits for the user, and what the user says not where it waits
// for time (language rules 10.1 and 12.16). For example, a handler of
// Door.Opened asks the database and waits. Another Door.Opened queues behind
// it; a Door.Closed goes to its own handlers at once. What the handler fires
// goes to the dialogue lane, which is not held by it.
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
#include "script/dialogue/engine/effects/handled_message.hpp"
#include "script/dialogue/engine/effects/waits.hpp"
#include "script/dialogue/engine/message_end.hpp"
#include "script/dialogue/engine/state_machine.hpp"
#include "script/dialogue/topic_engine/topic_engine.hpp"

namespace parlour::dialogue {

// Messages of one source and command that wait behind a handler that waits
// (engine rule 2.4). Without a limit, a sensor that reports ten times a second
// would fill the memory of a session whose handler waits for a slow service.
inline constexpr std::size_t max_held = 100;

// Owned by ConversationImplementation, which gives it one message after the
// other. It knows who waits in this lane; the activations themselves are with
// the ActivationRunner.
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
  // user goes straight to it (answers.hpp). All reactions run before it
  // returns, as far as none of them waits.
  void take(Input&& input);
  // An activation of this lane goes on, then the reactions behind it; false
  // where it is none of ours.
  bool resume(WaitId wait, Expected<Value> outcome);

  // Of all activations that wait in this lane, whatever for.
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
  // A message on its way through its reactions. It is on the stack while they
  // run, and is kept in `waiting_` while one of them waits.
  struct Item {
    std::shared_ptr<const Message> message;
    TurnId turn = 0;
    bool raised = false;
    std::vector<Reactions::Match> reactions;
    // The index of the next reaction. What waits or ran last is the one before.
    std::size_t next = 0;
    // No further reaction is to see it: <consume/>, a state with capture, or
    // one that was cancelled.
    bool consumed = false;
    bool is_said = false;   // by the user
    bool overflows = false; // too much is behind it
    // Whether it still holds the user turn open. While it waits for the user or
    // for time it does not: an open turn would keep questions from being asked.
    bool holds_turn = true;
    // 0 while its reactions run.
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

  // Puts the message behind one that waits, or drops it where too many are
  // there.
  void hold(Item& item, Input input);
  // Whether the message has to wait for the item (the table of engine rule
  // 2.4).
  static bool holds(const Item& item, const Input& input);
  // The one that waits and that this message must wait for; null: none.
  Item* waits_before(const Input& input) const;
  // Whether a reaction that waits for the user would get the message, too.
  bool asks_again(const Item& item) const;
  void go_on(Item& item);
  // What follows from a reaction that has just run: consumed, waits, handed
  // over.
  void started(Item& item, WaitId wait);
  // What is handed over becomes an item of the dialogue lane, which ends with
  // the question that is then due.
  void hand_over(StepList steps, TurnId turn);
  void finish(Item& item);
  void keep(Item&& item); // until what it waits for comes
  // Those behind it that it holds no more are the next messages.
  void let_go_of_held(Item& item);
  // Whether one of the reactions that ran names the message's source and event.
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
