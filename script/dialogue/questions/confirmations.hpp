// Confirmations: the <confirm>s of scripts that wait for a yes or no: asked,
// asked anew, and ended without an answer (language rule 12.20).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "script/dialogue/agenda/step_list.hpp"
#include "script/dialogue/context/asked.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/open_question.hpp"
#include "script/dialogue/context/running_script.hpp"
#include "script/dialogue/context/topic_frames.hpp"
#include "script/dialogue/questions/asking.hpp"

namespace parlour::dialogue {

class Confirmations {
public:
  Confirmations(DialogueContext& context, TopicFrames& frames,
                RunningScript& running, OpenQuestion& question, Asking& asking)
      : context_(context), frames_(frames), running_(running),
        question_(question), asking_(asking) {}

  // A <confirm>'s question, for the wait of its activation; about that slot,
  // or no_id.
  void confirm(std::string question, TopicId topic, SlotId slot, WaitId wait,
               TurnId turn);
  // A handler's has been answered with yes: what was asked before it waits
  // again.
  void back_to_question_before(const Asked& asked);
  const Asked* latest_confirm() const;   // null: none
  bool wants_a_yes(TopicId topic) const; // a <confirm> of its waits
  // Whether the topic waits for one: it settles when that has been answered.
  bool confirms_first(const steps::Settle& step);
  // It is no longer the question that waits.
  void forget_question(const Asked& confirm);
  // The steps that end them, with kind Cancelled.
  StepList end_confirms_of(TopicId topic);
  // A script has set or cleared a slot: what is asked about the topic is asked
  // anew.
  void slot_changed(TopicId topic);
  // What the body that begins puts an end to, before it runs.
  StepList overtaken_by(const Body& body);
  // The same, of values that are said about the topic.
  StepList overtaken_by_filling(TopicId topic);
  // The <confirm> that waits so is being ended.
  void forget_confirm(WaitId wait);
  void wait_is_over(WaitId wait);
  // The <confirm>s of all other topics.
  std::vector<WaitId> confirms_but_of(const std::vector<TopicId>& topics) const;
  // Whether its <completed> waits for a yes and has done nothing so far: the
  // topic is not done yet.
  bool is_completing(TopicId topic) const;
  TopicId completing() const; // the latest such
  // A yes that names a topic is for that one's.
  void prefer_named_confirm(TopicId topic);
  // All but these are over.
  void cancel_confirms(const std::vector<WaitId>& but);

  bool any() const {
    return !confirms_.empty();
  }
  const Asked& innermost() const {
    return confirms_.back();
  }
  const std::vector<Asked>& all() const { // innermost last
    return confirms_;
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive.without(context_, frames_, running_, question_, asking_);
    archive(confirms_);
  }

private:
  using ConfirmPredicate = std::function<bool(const Asked&)>;

  void note_question_before(Asked& asked, TurnId turn) const;
  bool may_be_answered(const Asked& asked) const;
  // The steps that end them, with kind Cancelled.
  StepList end_confirms(const ConfirmPredicate& wanted);

  DialogueContext& context_;
  TopicFrames& frames_;
  RunningScript& running_;
  OpenQuestion& question_;
  Asking& asking_;
  std::vector<Asked> confirms_; // innermost last
};

} // namespace parlour::dialogue
