// ConversationImplementation: what happens with each input. An internal
// header of this folder; the door is conversation.hpp.
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
#include "script/dialogue/engine/effect_handler.hpp"
#include "script/dialogue/engine/handled_message.hpp"
#include "script/dialogue/engine/heard_grammar.hpp"
#include "script/dialogue/engine/pipeline.hpp"
#include "script/dialogue/engine/sockets.hpp"
#include "script/dialogue/engine/state_machine.hpp"
#include "script/dialogue/engine/waits.hpp"
#include "script/dialogue/output/output_manager.hpp"
#include "script/dialogue/questions/question_parts.hpp"
#include "script/dialogue/saved/renames.hpp"
#include "script/dialogue/topic_engine/topic_engine.hpp"

namespace parlour::dialogue {

class ConversationImplementation {
public:
  ConversationImplementation(std::shared_ptr<const script::Program> program,
                             ConversationOptions options, Port& port);

  void open();
  void receive(std::shared_ptr<const Message> message);
  void take_acts(std::span<const ActPointer> acts);
  bool has_work() const;
  void take_input();
  // A new external event: what scripts may do is counted anew.
  void begin_event();
  // After each input: the lane runs as far as it can; what silence leads to.
  void go_on();
  void timer_fired(TimerId id);
  // The outcome of what a script wanted from outside.
  void answered(QueryId id, Expected<Value> outcome);
  // A script's wait is over: it goes on, in the lane in which it waits.
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

  // The steps that are nobody else's.
  void take(steps::Run&& step);
  void take(steps::RunLeaving&& step);
  void take(steps::RunTimer&& step);
  void take(steps::React&& step);
  void take(steps::ResumeWait&& step);
  void take(const steps::Cancel& step);
  void take(const steps::Restart& step);
  void take(const steps::End& step);

  // The parts, each of which knows those that it was made with.
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
  struct Watch {
    TimerId id = 0;
    Timer::Purpose purpose = Timer::Purpose::silence;
    Milliseconds length{0};

    template <class Archive>
    void serialize(Archive& archive) {
      archive(id, length);
      archive.up_to(purpose, Timer::Purpose::leaving);
    }
  };

  StepList beginning() const;
  Inbox::Of heard() const;
  void process(Input&& input);
  void user_begins();
  void note_speech(const Message& message, Timestamp now);
  bool hear_speech(const Message& message);
  bool hear_speaker(const Message& message);
  void act_on(Timer timer);
  void ring(Timer timer);
  void run_lane();
  void drop_what_was_too_much();
  void carry_out(Step&& step);
  template <class Kind>
  void run_body(Kind&& step);
  void ran(ActivationRunner::Ran what);
  void start_over();

  void leave();
  void take_internal();
  bool is_quiescent() const;
  void finish();
  void tell_lost_timers();
  void give_up_turns();

  void watch_silence();
  void watch_nobody();
  void watch_for(Milliseconds length, Timer::Purpose purpose);
  void stop_silence();

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
