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
#include "script/dialogue/topic_engine/course/refusals.hpp"
#include "script/dialogue/topic_engine/course/topic_changes.hpp"

namespace parlour::dialogue {

// The life of a lookup: LookUp asks a statement, LookedUp has its rows, Answer
// comes when <filled> has run. LookUp and LookedUp take turns while queries are
// relaxed; the steps share one Lookup. At most one query is on its way, as the
// dialogue lane is held meanwhile (engine rule 2.4).
class Enquiries {
public:
  Enquiries(DialogueContext& context, Messenger& messenger,
            OutputManager& output, TopicFrames& frames, TopicWords& words,
            Refusals& refusals, TopicChanges& topic_changes)
      : context_(context), messenger_(messenger), output_(output),
        frames_(frames), words_(words), refusals_(refusals),
        topic_changes_(topic_changes) {}

  // Without a lookup, the topic's first statement is made, from the slots as
  // they are now; with one, that statement is asked. A topic without queries is
  // answered by its <filled> alone.
  void take(steps::LookUp&& step);
  // The rows, or why there are none. Without rows, the next statement is tried
  // (engine rule 6.3); after the last one, the empty result is the answer.
  void take(steps::LookedUp&& step);
  // The enquiry rests from here on.
  void take(const steps::Answer& step);
  // The topic's <filled>, then the engine's own answer.
  void answer_enquiry(TopicId topic, TurnId turn);
  // Another port is asked for the query that waits, as a topic's query only
  // reads (engine rule 7.9); nothing where none waits.
  void resume() const;
  // False where the query is not of a topic, or no longer wanted. `outcome` is
  // rows, unknown for none, or an error; it is moved from where it is taken.
  bool query_answered(QueryId id, Expected<Value>& outcome);

  bool waits_for_answer() const {
    return query_.has_value();
  }
  // Its answer is wanted no more; whoever calls this ends the lane's wait.
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
  // The query that waits, with the step whose statement it asks.
  struct Query {
    QueryId id = 0;
    steps::LookUp step;

    template <class Archive>
    void serialize(Archive& archive) {
      archive(id, step);
      archive.needs(step.lookup);
    }
  };

  // At once, without the port.
  void look_up_facts(steps::LookUp& step);
  void refuse_source(steps::LookUp& step);

  DialogueContext& context_;
  Messenger& messenger_;
  OutputManager& output_;
  TopicFrames& frames_;
  TopicWords& words_;
  Refusals& refusals_;
  TopicChanges& topic_changes_;
  // Empty: no query is on its way.
  std::optional<Query> query_;
};

} // namespace parlour::dialogue
