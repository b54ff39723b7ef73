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

class TopicEngine {
public:
  TopicEngine(DialogueContext& context, Messenger& messenger,
              TopicFrames& frames, RunningScript& running, TextEvaluator& texts,
              const ActivationRunner& runner, OpenQuestion& question,
              OutputManager& output, QuestionParts& questions);

  // A step that belongs to topics; it may put further ones in front.
  template <class Kind>
  void take(Kind&& step) {
    give(std::forward<Kind>(step), questions_.reprompts,
         questions_.next_question, changes_, enquiries_, settling_, outcome_,
         filling_, yes_or_no_, silence_, ends_, acts_, entry_);
  }
  void restart();

  // -- acts --
  // Whether a script waits for this act.
  bool is_waited_for(const Act& act) const {
    return entry_.is_waited_for(act);
  }
  // A yes or no waited for what else might follow in the same breath, and
  // nothing did: it is queued.
  bool nothing_followed() {
    return breath_.nothing_followed();
  }
  // Silence has lasted: the next question, resume or reprompt.
  void silence() {
    silence_.silence();
  }
  // The question that was heard last, if it is still open.
  void ask_again() {
    silence_.repeat();
  }
  // How long silence must last now; nothing where it leads nowhere.
  std::optional<Milliseconds> silence_wanted() const {
    return silence_.silence_wanted();
  }
  // The context of DoNLU (runtime/message/understanding.hpp).
  Value understanding_context() const {
    return questions_.whereabouts.understanding_context();
  }

  // -- what waits --
  // The <confirm> that waits so is being ended.
  void forget_confirm(WaitId wait) {
    questions_.confirmations.forget_confirm(wait);
  }
  // The <confirm>s of all other topics.
  std::vector<WaitId>
  confirms_but_of(const std::vector<TopicId>& topics) const {
    return questions_.confirmations.confirms_but_of(topics);
  }
  // What the body that begins puts an end to, before it runs.
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

  // The parts, each of which knows those before it.
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
