// OpenQuestion: the question that waits for the user's answer, from the moment
// it is put, and what became of its words (engine rules 3 and 5). Plain data
// with its transitions: who asks is in questions/asking.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "script/dialogue/agenda/output_queue.hpp"
#include "script/dialogue/context/asked.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/topic_frames.hpp"

namespace parlour::dialogue {

// At most one question waits. It may be asked (`pending`), heard, or withdrawn
// and still to be asked again; what silence leads to depends on that (engine
// rule 3.8).
class OpenQuestion {
public:
  OpenQuestion(DialogueContext& context, TopicFrames& frames)
      : context_(context), frames_(frames) {}

  // What became of an output, which may be its words.
  void released(const Output& output);
  void withdrawn(const Output& output);
  void unspoken(OutputId output); // no words were found for it
  // The user broke in on it, and heard these words.
  void broken_off(const Output& output, const std::string& heard);
  // What was broken off is said again, as another output.
  void said_again(OutputId before, OutputId now);
  // Whether what the user says now is private in any case.
  bool asks_in_private() const;
  bool asked_here() const; // not below a pushed state
  // The slot that a question about that topic is for; or no_id.
  SlotId slot_asked_for(TopicId topic) const;

  explicit operator bool() const { // whether there is one
    return asked_.has_value();
  }
  const Asked* operator->() const {
    return &*asked_;
  }
  const Asked& operator*() const {
    return *asked_;
  }
  // Another question takes the place of the one before.
  void set(Asked asked) {
    asked_ = std::move(asked);
  }
  void reset() {
    asked_.reset();
  }
  void reset_of(TopicId topic) {
    if (asked_ && asked_->topic == topic)
      asked_.reset();
  }
  Asked take() {
    return *std::exchange(asked_, {});
  }
  // Something else was said since: there must be a question. A yes that comes
  // now is not sure to be meant for it, so it is asked again (engine rule 5.8).
  void interrupt() {
    asked_->interrupted = true;
  }
  // One more time that it was not answered; the count. There must be a
  // question, and one without a slot to count at.
  std::uint32_t count_miss() {
    return ++asked_->missed;
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive.without(context_, frames_);
    archive(asked_);
  }

private:
  // The marks of implicit values (engine rule 5.5) were used.
  void unmark(TopicId topic);

  DialogueContext& context_;
  TopicFrames& frames_;
  std::optional<Asked> asked_;
};

} // namespace parlour::dialogue
