// Enquiries: topics look things up, and answer (engine rule 6; paper IV.B,
// Fig. 3).
#pragma once

#include <optional>

#include "script/dialogue/agenda/step_list.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/messenger.hpp"
#include "script/dialogue/context/topic_frames.hpp"
#include "script/dialogue/output/output_manager.hpp"
#include "script/dialogue/questions/topic_words.hpp"
#include "script/dialogue/topic_engine/refusals.hpp"
#include "script/dialogue/topic_engine/topic_changes.hpp"

namespace parlour::dialogue {

class Enquiries {
public:
  Enquiries(DialogueContext& context, Messenger& messenger,
            OutputManager& output, TopicFrames& frames, TopicWords& words,
            Refusals& refusals, TopicChanges& topic_changes)
      : context_(context), messenger_(messenger), output_(output),
        frames_(frames), words_(words), refusals_(refusals),
        topic_changes_(topic_changes) {}

  void take(steps::LookUp&& step);
  void take(steps::LookedUp&& step);
  void take(const steps::Answer& step);
  // The topic's <filled>, then the engine's own answer.
  void answer_enquiry(TopicId topic, TurnId turn);
  // Another port is asked, as a topic's query only reads.
  void resume() const;
  // False where the query is not of a topic.
  bool query_answered(QueryId id, Expected<Value>& outcome);

  bool waits_for_answer() const {
    return query_.has_value();
  }
  void forget() {
    query_.reset();
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive.without(context_, messenger_, output_, frames_, words_, refusals_,
                    topic_changes_);
    archive(query_);
  }

private:
  struct Query {
    QueryId id = 0;
    steps::LookUp step;

    template <class Archive>
    void serialize(Archive& archive) {
      archive(id, step);
      archive.needs(step.lookup);
    }
  };

  void look_up_facts(steps::LookUp& step);
  void refuse_source(steps::LookUp& step);

  DialogueContext& context_;
  Messenger& messenger_;
  OutputManager& output_;
  TopicFrames& frames_;
  TopicWords& words_;
  Refusals& refusals_;
  TopicChanges& topic_changes_;
  std::optional<Query> query_;
};

} // namespace parlour::dialogue
