// TopicEngine: the paper's frame manager and topic engine (engine rule 5) as
// the rest of a conversation sees it. It makes the parts, each with what it
// uses, and gives each step to the part that takes it.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "script/dialogue/agenda/give.hpp"
#include "script/dialogue/questions/question_parts.hpp"
#include "script/dialogue/topic_engine/act_entry.hpp"

namespace parlour::dialogue {

// Each conversation has one. Only that conversation's own thread of work calls
// it, one input at a time (engine rule 2.1), so nothing here locks. What a
// script does wrong becomes the event Script.Error; nothing is returned for it.
// The references must outlive it; the conversation makes them all.
//
// Two ways lead out of a part: it puts steps in front of what the lane still
// has to do, or it changes a frame at once. A part never waits. Where an answer
// must come first (a frame, a query) it keeps what it needs, and the lane rests
// until the answer arrives as an input of its own.
class TopicEngine {
public:
  TopicEngine(DialogueContext& context, Messenger& messenger,
              TopicFrames& frames, RunningScript& running, TextEvaluator& texts,
              const ActivationRunner& runner, OpenQuestion& question,
              OutputManager& output, QuestionParts& questions);

  // A step that belongs to topics; it may put further ones in front. `give`
  // finds the part by the step's type when this is compiled: of the parts
  // listed, the one that has a `take` for it.
  template <class Kind>
  void take(Kind&& step) {
    give(std::forward<Kind>(step), questions_.reprompts,
         questions_.next_question, changes_, enquiries_, settling_, outcome_,
         filling_, yes_or_no_, silence_, ends_, acts_, entry_);
  }
  // The conversation starts over: all topics are untouched, no question waits.
  // The caller ends the scripts that wait.
  void restart();

  // Whether a script waits for this act. A handler in the pipeline lane that
  // waits for the user asks it before it is given the words (engine rule 2.4).
  bool is_waited_for(const Act& act) const {
    return entry_.is_waited_for(act);
  }
  // To be called when the lane has run as far as it can. A yes or no waited for
  // what else might follow in the same breath, and nothing did: true, it is
  // queued, and the lane has to run again.
  bool nothing_followed() {
    return breath_.nothing_followed();
  }
  // The timer that silence_wanted() has asked for rang: the next question, a
  // resumed topic or a reprompt. It only queues steps or outputs.
  void silence() {
    silence_.silence();
  }
  // The question that was heard last comes again, if it is still open; else
  // nothing.
  void ask_again() {
    silence_.repeat();
  }
  // How long silence must last now, in milliseconds; nothing where it leads
  // nowhere. It changes with every input, so it is asked after each.
  std::optional<Milliseconds> silence_wanted() const {
    return silence_.silence_wanted();
  }
  // The context of DoNLU (runtime/message/understanding.hpp).
  Value understanding_context() const {
    return questions_.whereabouts.understanding_context();
  }

  // The <confirm> that waits so is being ended by others than the topic engine:
  // its state was left, or its handler asks again.
  void forget_confirm(WaitId wait) {
    questions_.confirmations.forget_confirm(wait);
  }
  // The <confirm>s of all other topics.
  std::vector<WaitId>
  confirms_but_of(const std::vector<TopicId>& topics) const {
    return questions_.confirmations.confirms_but_of(topics);
  }
  // What the body that begins puts an end to, before it runs: an earlier run of
  // the same body that still waits for a yes. Empty: it can run at once.
  StepList overtaken_by(const Body& body) {
    return questions_.confirmations.overtaken_by(body);
  }
  // A script goes on that waited so, or was ended.
  void wait_is_over(WaitId wait) {
    questions_.confirmations.wait_is_over(wait);
  }
  // A script of the topic ended with an error that no <catch> took.
  void body_failed(TopicId topic, CodeId body) {
    refusals_.body_failed(topic, body);
  }
  // All that scripts and topics wait for is over, but these waits.
  void forget_waits(const std::vector<WaitId>& but) {
    questions_.confirmations.cancel_confirms(but);
    refusals_.clear();
    enquiries_.forget();
  }
  // No question waits any more (Asking).
  void withdraw_question() {
    questions_.asking.withdraw();
  }
  // The topics that the user wants out of, and the steps that end them.
  std::vector<TopicId> meant_by(const steps::Cancel& step) const {
    return ends_.meant_by(step);
  }
  StepList cancel(const std::vector<TopicId>& topics, TurnId turn) {
    return ends_.cancel(topics, turn);
  }
  // A topic whose wait for the user is over is the current one: the steps that
  // this takes.
  StepList back_to(TopicId topic) {
    return changes_.back_to(topic);
  }
  // While a frame is awaited the session takes no other input, and no further
  // step (engine rule 5.12).
  bool awaiting_frame() const {
    return filling_.awaits_frame();
  }
  void frame_applied(FrameResult result) {
    filling_.frame_applied(std::move(result));
  }
  // The session ends: the frame's answer is wanted no more.
  void forget_frame() {
    filling_.forget_frame();
  }
  // Another port is asked for what is awaited.
  void resume() const {
    filling_.resume();
    enquiries_.resume();
  }
  // False: the query is none of a topic's, and `outcome` is untouched. True:
  // `outcome` was moved from, and the lane goes on with it.
  bool query_answered(QueryId id, Expected<Value>& outcome) {
    return enquiries_.query_answered(id, outcome);
  }
  bool waits_for_answer() const {
    return enquiries_.waits_for_answer();
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive.without(frames_, questions_);
    // They keep nothing.
    archive.without(confirm_answers_, outcome_, beside_, yes_or_no_outcome_,
                    yes_or_no_, ends_, repair_acts_, late_corrections_,
                    delivery_, acts_, entry_);
    archive(filling_, enquiries_, breath_, refusals_, changes_, settling_,
            silence_);
  }

private:
  TopicFrames& frames_;
  QuestionParts& questions_;

  // The parts, each of which knows only those before it. The order is that of
  // construction, so a part's references are good when it is made; it also
  // keeps calls in one direction.
  Refusals refusals_;
  TopicChanges changes_;
  Enquiries enquiries_;
  Settling settling_;
  ConfirmAnswers confirm_answers_;
  FillingOutcome outcome_;
  Filling filling_;
  Breath breath_;
  SaidBeside beside_;
  YesOrNoOutcome yes_or_no_outcome_;
  YesOrNo yes_or_no_;
  Silence silence_;
  TopicEnds ends_;
  RepairActs repair_acts_;
  LateCorrections late_corrections_;
  ActDelivery delivery_;
  TopicActs acts_;
  ActEntry entry_;
};

} // namespace parlour::dialogue
