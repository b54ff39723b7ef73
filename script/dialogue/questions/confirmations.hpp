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

// A <confirm> is an activation that waits, and an entry here as long as it
// does. Several may wait: the user goes on to another topic while one is asked,
// so the innermost, which was asked last, is asked first. Which one is being
// asked now is OpenQuestion's. Entries outlive their question: one that others
// came in front of is asked again after silence.
//
// Ending a <confirm> never touches its activation at once: it is made a step,
// which resumes the script with an error of kind Cancelled.
class Confirmations {
public:
  Confirmations(DialogueContext& context, TopicFrames& frames,
                RunningScript& running, OpenQuestion& question, Asking& asking)
      : context_(context), frames_(frames), running_(running),
        question_(question), asking_(asking) {}

  // A <confirm>'s question, for the wait of its activation; about that slot, or
  // no_id. `topic` is no_id in handlers and states. It is asked at once.
  void confirm(std::string question, TopicId topic, SlotId slot, WaitId wait,
               TurnId turn);
  // The same about all that the topic was told (engine rule 5.13).
  void summarise(TopicId topic, WaitId wait, TurnId turn);
  // A handler's has been answered with yes: what was asked before it waits
  // again, unless it cannot be answered any more. Nothing happens for other
  // <confirm>s.
  void back_to_question_before(const Asked& asked);
  // Of those that wait for an answer the one that was asked last; null: none.
  // The pointer is good until the next change here.
  const Asked* latest_confirm() const;
  bool wants_a_yes(TopicId topic) const; // a <confirm> of its waits
  // Whether the topic waits for a <confirm>: it settles when that has been
  // answered, and the question is made anew. False: it can settle now.
  bool confirms_first(const steps::Settle& step);
  // It is no longer the question that waits; its words are withdrawn. It stays
  // an entry.
  void forget_question(const Asked& confirm);
  // The steps that end all <confirm>s of the topic, with kind Cancelled; none
  // where nothing waits. They are no entries any more.
  StepList end_confirms_of(TopicId topic);
  // A script has set or cleared a slot: what is asked about the topic is asked
  // anew. The running script asks for the steps, so they come when it ends.
  void slot_changed(TopicId topic);
  // What the body that begins puts an end to, before it runs: the same body of
  // the same topic, which waits.
  StepList overtaken_by(const Body& body);
  // The same, of values that are said about the topic: <confirm>s of its
  // <filled> and its rules.
  StepList overtaken_by_filling(TopicId topic);
  // The <confirm> that waits so is being ended by others: it is neither an
  // entry nor the open question any more.
  void forget_confirm(WaitId wait);
  // Its script goes on, with an answer or an error. Unknown waits do not
  // matter.
  void wait_is_over(WaitId wait);
  // The <confirm>s of all other topics; not those of handlers and states.
  std::vector<WaitId> confirms_but_of(const std::vector<TopicId>& topics) const;
  // Whether its <completed> waits for a yes and has done nothing so far: the
  // topic is not done yet.
  bool is_completing(TopicId topic) const;
  // The latest topic for which is_completing() holds; or no_id.
  TopicId completing() const;
  // A yes that names a topic is for that one's <confirm>, which becomes the
  // open question. Nothing happens for no_id and where none of it waits.
  void prefer_named_confirm(TopicId topic);
  // All but these are over. No steps are made: the caller ends the waits.
  void cancel_confirms(const std::vector<WaitId>& but);

  bool any() const {
    return !confirms_.empty();
  }
  // any() must hold.
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

  // What all <confirm>s of the running script have in common.
  Asked waiting(TopicId topic, WaitId wait) const;
  void note_question_before(Asked& asked, TurnId turn) const;
  // Whether what it asked for is still wanted.
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
