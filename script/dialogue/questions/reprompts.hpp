// Reprompts: questions that are not answered are asked again, up a ladder: when
// nothing was understood, nobody said anything, or what was said does not fit
// (engine rule 5).
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "script/dialogue/agenda/step_list.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/open_question.hpp"
#include "script/dialogue/context/running_script.hpp"
#include "script/dialogue/context/text_evaluator.hpp"
#include "script/dialogue/context/topic_frames.hpp"
#include "script/dialogue/questions/asking.hpp"
#include "script/dialogue/questions/clarification.hpp"
#include "script/dialogue/questions/confirmations.hpp"
#include "script/dialogue/questions/offers.hpp"
#include "script/dialogue/questions/repair_runner.hpp"
#include "script/dialogue/questions/topic_words.hpp"

namespace parlour::dialogue {

// Engine rule 5.10. The count of misses is kept with the slot in its frame, or,
// for a question without a slot, with the question.
class Reprompts {
public:
  Reprompts(DialogueContext& context, RunningScript& running, Offers& offers,
            TopicFrames& frames, TextEvaluator& texts, TopicWords& words,
            OpenQuestion& question, Asking& asking,
            Clarification& clarification, RepairRunner& repairs)
      : context_(context), running_(running), offers_(offers), frames_(frames),
        texts_(texts), words_(words), question_(question), asking_(asking),
        clarification_(clarification), repairs_(repairs) {}

  // Nothing was understood: offered to who listens to Dialogue.no_match; else
  // it counts on the question that was asked, which comes again; without one an
  // apology, unless somebody else made it (`apologised`). `heard`: the words,
  // or empty. Nothing happens if the user has said more since that turn.
  void misunderstood(TurnId turn, std::string heard, bool apologised = false);
  // Nobody kept the no_match.
  void take(const steps::NotUnderstood& step);
  // Nobody kept the silence.
  void take(const steps::NoInput& step);
  // By a script's <ask>, or a topic that settles. Without a slot: what to
  // change.
  void take(const steps::Ask& step);
  // Behind a step of the application's ladder.
  void take(const steps::AskStill& step);
  // A script's <ask/> in a <repair>: the question that waits, if one does.
  void take(const steps::AskAgain& step);
  // As Asking does; but a slot whose answer was refused for the second time or
  // more leads up the ladder instead.
  void ask_slot(TopicId topic, SlotId slot, OutputAct as, TurnId turn);
  // In the words that were heard. There must be an open question; this is no
  // miss of it.
  void repeat_question(TurnId turn);
  // The user has not answered, but said why not; returns how often in a row.
  std::uint32_t count_evasion() {
    return count_miss(true);
  }
  // An answer that does not fit counts as one that was not understood. A slot
  // that was never asked for has no answer, so nothing is counted.
  void count_refusal(TopicId topic, SlotId slot);

  // The user has said something else: what was refused before belongs to the
  // past.
  void act_begins() {
    refused_.reset();
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive.without(context_, running_, offers_, frames_, texts_, words_,
                    question_, asking_, clarification_, repairs_);
    archive(refused_);
  }

private:
  struct SlotOf {
    TopicId topic = script::no_id;
    SlotId slot = script::no_id;

    template <class Archive>
    void serialize(Archive& archive) {
      archive.slot(topic, slot);
    }
  };

  // There must be an open question, which was heard.
  void reprompt(TurnId turn, bool heard_something);
  void climb(const Trouble& trouble);
  // Returns the count after it: 1 for the first time in a row.
  std::uint32_t count_miss(bool heard_something);
  // Whether the ladder asks, in place of the question.
  bool climb_after_refusal(TopicId topic, SlotId slot, TurnId turn);
  // The slot's <nomatch> or <noinput> that holds for the count; false: it has
  // none.
  bool run_own_words(const Trouble& trouble);
  void climb_own(const Trouble& trouble);

  DialogueContext& context_;
  RunningScript& running_;
  Offers& offers_;
  TopicFrames& frames_;
  TextEvaluator& texts_;
  TopicWords& words_;
  OpenQuestion& question_;
  Asking& asking_;
  Clarification& clarification_;
  RepairRunner& repairs_;
  std::optional<SlotOf> refused_; // by this act, though it had been asked for
};

} // namespace parlour::dialogue
