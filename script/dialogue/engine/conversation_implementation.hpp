// ConversationImplementation: what happens with each input. An internal header
// of this folder; the door is conversation.hpp.
//
// Each input is dealt with in the same way: begin_event() where it comes from
// outside, then what the input itself does, then go_on(), which runs the
// dialogue lane, ends what is to end, and watches for silence. The functions
// are in the files conversation_*.cpp of this folder, by subject.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "script/dialogue/agenda/timers.hpp"
#include "script/dialogue/agenda/wait_outcome.hpp"
#include "script/dialogue/context/activation_runner.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/inbox.hpp"
#include "script/dialogue/context/messenger.hpp"
#include "script/dialogue/context/open_question.hpp"
#include "script/dialogue/context/reactions.hpp"
#include "script/dialogue/context/running_script.hpp"
#include "script/dialogue/context/script_view.hpp"
#include "script/dialogue/context/text_evaluator.hpp"
#include "script/dialogue/context/topic_frames.hpp"
#include "script/dialogue/engine/answers.hpp"
#include "script/dialogue/engine/effects/effect_handler.hpp"
#include "script/dialogue/engine/effects/handled_message.hpp"
#include "script/dialogue/engine/effects/sockets.hpp"
#include "script/dialogue/engine/effects/waits.hpp"
#include "script/dialogue/engine/heard_grammar.hpp"
#include "script/dialogue/engine/pipeline.hpp"
#include "script/dialogue/engine/state_machine.hpp"
#include "script/dialogue/output/output_manager.hpp"
#include "script/dialogue/questions/question_parts.hpp"
#include "script/dialogue/saved/renames.hpp"
#include "script/dialogue/topic_engine/topic_engine.hpp"

namespace parlour::dialogue {

// Owns all parts of one conversation. Conversation sets the time before it
// calls anything here, and keeps away inputs that come after the end.
class ConversationImplementation {
public:
  ConversationImplementation(std::shared_ptr<const script::Program> program,
                             ConversationOptions options, Port& port);

  void open();
  void receive(std::shared_ptr<const Message> message);
  void take_acts(std::span<const ActPointer> acts);
  // See Conversation.
  bool has_work() const;
  // The next of what is ready, in the order of engine rule 2.1. There must be
  // some.
  void take_input();
  // A new external event: what scripts may do (fuel, internal events) is
  // counted anew (engine rules 2.6 and 2.7).
  void begin_event();
  // After each input: the lane runs as far as it can; what silence leads to.
  // While the session ends, its end goes on instead.
  void go_on();
  void timer_fired(TimerId id);
  // The outcome of what a script wanted from outside.
  void answered(QueryId id, Expected<Value> outcome);
  // A script's wait is over: it goes on, in the lane in which it waits. Nothing
  // happens where nothing waits so any more.
  void end_wait(WaitOutcome over);
  // With another port.
  void resume();
  void close();
  std::vector<Message> take_unread();
  // Nothing runs, waits or is said.
  bool is_at_rest() const;
  // What waits in scripts ends with an error.
  void end_scripts();
  // The dialogue of `before`, which is at rest; what of it is lost.
  std::vector<std::string> take_over(const ConversationImplementation& before,
                                     const Renames& renames);

  // The steps that are nobody else's; run_lane finds the taker of each
  // (agenda/give.hpp).
  void take(steps::Run&& step);
  void take(steps::RunLeaving&& step);
  void take(steps::RunTimer&& step);
  void take(steps::React&& step);
  void take(steps::ResumeWait&& step);
  void take(const steps::Cancel& step);
  void take(const steps::Restart& step);
  void take(const steps::End& step);

  // The parts, each of which knows those that it was made with. Their order is
  // that of their making: a part is declared behind those that its constructor
  // uses. `runner` alone refers to a later one, `effects`, which no script
  // needs before the first input.
  script::Interpreter interpreter;
  DialogueContext context;
  Timers timers;
  Inbox inbox;
  Messenger messenger;
  TopicFrames frames;
  Reactions reactions;
  ScriptView view;
  TextEvaluator texts;
  RunningScript running;
  ActivationRunner runner;
  OpenQuestion question;
  OutputManager output;
  QuestionParts questions;
  TopicEngine topics;
  ScriptSockets sockets;
  RequestEffects requests;
  OutsideEffects outside;
  Waits waits;
  StateMachine machine;
  HeardGrammar heard_grammar;
  Answers answers;
  MessageEnd message_end;
  HandledMessage handled;
  Pipeline pipeline;
  TopicEffects topic_effects;
  ReactionEffects reaction_effects;
  TimeEffects time_effects;
  EffectHandler effects;

  template <class Archive>
  void serialize(Archive& archive) {
    archive.without(interpreter); // it is saved beside them
    // They keep nothing.
    archive.without(messenger, texts, waits, message_end, handled,
                    topic_effects, reaction_effects, time_effects, effects);
    archive(timers, context, inbox, frames, reactions, view, running, runner,
            question, output, questions, topics, machine, heard_grammar,
            answers, sockets, pipeline, requests, outside, watch_, lost_);
  }

private:
  // The timer that watches silence, while there is one.
  struct Watch {
    TimerId id = 0;
    Timer::Purpose purpose = Timer::Purpose::silence;
    // How long it lasts in all: another length is another reason to watch, and
    // begins anew.
    Milliseconds length{0};

    template <class Archive>
    void serialize(Archive& archive) {
      archive(id, length);
      archive.up_to(purpose, Timer::Purpose::leaving);
    }
  };

  // What is done when the session begins or starts over; empty: nothing.
  StepList beginning() const;
  // Whose messages are taken now.
  Inbox::Of heard() const;
  // A message, to who reacts to it.
  void process(Input&& input);
  // The user has said something: silence is over, and the robot's turn.
  void user_begins();
  void note_speech(const Message& message, Timestamp now);
  // What the engine itself does about a message; true: it has dealt with it,
  // and nobody else has to take it.
  bool hear_speech(const Message& message);
  bool hear_speaker(const Message& message);
  // What a timer that rang means.
  void act_on(Timer timer);
  void ring(Timer timer);
  void run_lane();
  void drop_what_was_too_much();
  void carry_out(Step&& step);
  template <class Kind>
  void run_body(Kind&& step);
  // An activation of the dialogue lane has ended, or waits.
  void ran(ActivationRunner::Ran what);
  void start_over();

  // The end, as far as it comes now (conversation_ends.cpp).
  void leave();
  void take_internal();
  bool is_quiescent() const;
  void finish();
  void tell_lost_timers();
  void give_up_turns();

  // Sees to it that silence, if it lasts, is noticed (engine rule 3.8).
  void watch_silence();
  void watch_nobody();
  void watch_for(Milliseconds length, Timer::Purpose purpose);
  void stop_silence();

  // What was wanted of another port will not come: the script is told by one of
  // the next steps.
  void lose(WaitOutcome over);

  // -- from another program, each with what is lost
  using Losses = std::vector<std::string>;
  void take_variables(const ConversationImplementation& before,
                      const Renames& renames, Losses& lost);
  void take_frames(const ConversationImplementation& before,
                   const Renames& renames, Losses& lost);
  void take_frame(const TopicFrame& before, TopicId topic,
                  const Renames& renames, Losses& lost);
  void take_states(const ConversationImplementation& before,
                   const Renames& renames, Losses& lost);
  void take_timers(const ConversationImplementation& before,
                   const Renames& renames, Losses& lost);
  void take_question(const ConversationImplementation& before,
                     const Renames& renames, Losses& lost);

  std::optional<Watch> watch_;
  Fifo<WaitOutcome> lost_; // to be told to who waits
};

} // namespace parlour::dialogue
