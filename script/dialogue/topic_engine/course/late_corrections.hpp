// LateCorrections: what is said of the topic that was completed last: a
// <repair> says what is done about a change, and what is known already begins
// nothing (engine rule 5.3).
#pragma once

#include <optional>
#include <string_view>

#include "script/dialogue/agenda/step_list.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/topic_frames.hpp"
#include "script/dialogue/questions/confirmations.hpp"
#include "script/dialogue/questions/repair_runner.hpp"
#include "script/dialogue/topic_engine/course/settling.hpp"
#include "script/dialogue/topic_engine/course/topic_changes.hpp"

namespace parlour::dialogue {

// "A taxi at three." (ordered) "No, at four.": a second taxi must not be
// ordered unasked, so the platform's <repair act="correct"> asks first. It
// keeps nothing; TopicChanges keeps the act until the <repair> has its answer.
class LateCorrections {
public:
  LateCorrections(DialogueContext& context, TopicFrames& frames,
                  Confirmations& confirmations, RepairRunner& repairs,
                  TopicChanges& topic_changes, Settling& settling)
      : context_(context), frames_(frames), confirmations_(confirmations),
        repairs_(repairs), topic_changes_(topic_changes), settling_(settling) {}

  enum class Outcome {
    no_concern, // about something else, or no <repair> is for it
    taken,
    says_again, // nothing that is not known; acknowledging it is left
  };
  Outcome take(const steps::TopicAct& step);

  // What "forget that" is about where nothing can be cancelled: the topic, if a
  // <repair act="cancel"> of its own says what is done then; or no_id.
  TopicId taken_back() const;

private:
  // The topic that is meant at all.
  std::optional<TopicId> just_done() const;
  Outcome judge(TopicId topic, const Act& act) const;
  bool has_own_repair(TopicId topic, std::string_view act) const;

  DialogueContext& context_;
  TopicFrames& frames_;
  Confirmations& confirmations_;
  RepairRunner& repairs_;
  TopicChanges& topic_changes_;
  Settling& settling_;
};

} // namespace parlour::dialogue
