// Whereabouts: where the conversation is, for the classifier, for the
// understanding with each DoNLU, and for who asks what is unfinished.
#pragma once

#include <string>
#include <vector>

#include "script/dialogue/agenda/step_list.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/open_question.hpp"
#include "script/dialogue/context/topic_frames.hpp"
#include "script/dialogue/questions/confirmations.hpp"
#include "script/dialogue/questions/topic_words.hpp"
#include "script/dialogue/topics/classifier.hpp"

namespace parlour::dialogue {

// It only reads what other parts know, at the moment when it is asked; of its
// own it keeps which slots the user spoke about last.
class Whereabouts {
public:
  Whereabouts(DialogueContext& context, TopicFrames& frames,
              const TopicWords& words, OpenQuestion& question,
              Confirmations& confirmations)
      : context_(context), frames_(frames), words_(words), question_(question),
        confirmations_(confirmations) {}

  // For classify() and its like. The context refers to the order of topics, and
  // is good until that changes.
  ClassifierContext classifier_context() const;
  // The topic that the act names, if it is registered; else the one that it is
  // about, as things stand; or no_id.
  TopicId topic_of(const Act& act) const;
  // The context of DoNLU (runtime/message/understanding.hpp), a map: what is
  // asked, or was before an aside, choices between candidates, topics by their
  // status, the grammar to try, the words of a question of yes or no, the time.
  Value understanding_context() const;
  // The only grammar that is tried now (language rule 12.18); empty: all.
  const std::string& narrowing_grammar() const {
    return narrowing_grammar(classifier_context());
  }
  // After each filling event. The answer to a value in doubt has no act, and
  // says nothing new.
  void note_what_was_said(const steps::Fill& step, const FrameResult& result);
  // The current topic first, then those that were suspended.
  std::vector<TopicId> unfinished() const;
  List unfinished_names() const;
  // The name of the topic's status: while it waits for a yes to its completion,
  // it is still active. Unknown for no_id.
  Value status_of(TopicId topic) const;

  // Neither ended nor untouched.
  bool goes_on(TopicId topic) const;

  void forget() {
    said_ = {};
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive.without(context_, frames_, words_, question_, confirmations_);
    archive(said_);
  }

private:
  // The slots that a correction may be about, beside the one that is asked for.
  List names_said_before(SlotId asked) const;
  const std::string& narrowing_grammar(const ClassifierContext& context) const;
  const std::string* yes_or_no_asked() const;
  TopicId waiting_topic(const ClassifierContext& context) const;
  Map names_of_slots(TopicId topic) const;

  DialogueContext& context_;
  TopicFrames& frames_;
  const TopicWords& words_;
  OpenQuestion& question_;
  Confirmations& confirmations_;
  struct Said {
    TopicId topic = script::no_id;
    std::vector<SlotId> slots;

    template <class Archive>
    void serialize(Archive& archive) {
      archive.topic(topic);
      archive.slots_of(topic, slots);
    }
  } said_; // what the user gave values for last, fitting or not
};

} // namespace parlour::dialogue
