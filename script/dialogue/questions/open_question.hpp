// OpenQuestion: the question that waits for the user's answer, from the moment
// it is put; what became of its words (engine rules 3 and 5).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/topic_frames.hpp"
#include "script/dialogue/output/output_manager.hpp"
#include "script/dialogue/questions/asked.hpp"
#include "script/dialogue/questions/topic_words.hpp"

namespace parlour::dialogue {

class OpenQuestion {
public:
  OpenQuestion(DialogueContext& context, OutputManager& output,
               TopicFrames& frames, TopicWords& words)
      : context_(context), output_(output), frames_(frames), words_(words) {}

  // Says it, as that act of the engine or with those words: from now on it is
  // the question that waits.
  void put(Asked&& asked, const char* act, Value data, std::string text,
           OutputAct as, TurnId turn);
  // For the slot's value, or what is in doubt about it.
  void ask_slot(TopicId topic, SlotId slot, OutputAct as, TurnId turn);
  // Between its candidates; not aloud where a script has asked.
  void ask_choice(TopicId topic, SlotId slot, TurnId turn, bool aloud);
  // What became of an output (OutputManager::Listener).
  void released(const Output& output);
  void withdrawn(const Output& output);
  void unspoken(OutputId output);
  void broken_off(const Output& output, const std::string& heard);
  void said_again(OutputId before, OutputId now);
  // Whether what the user says now is private in any case.
  bool asks_in_private() const;
  bool asked_here() const; // not below a pushed state
  // Of that topic; or no_id.
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
  // Words that others have said ask it.
  void set(Asked asked) {
    asked_ = std::move(asked);
  }
  void reset() {
    asked_.reset();
  }
  // Nor are questions said that wait for their release.
  void withdraw() {
    withdraw_words();
    reset();
  }
  void withdraw_words() {
    output_.withdraw_questions();
  }
  void reset_of(TopicId topic) {
    if (asked_ && asked_->topic == topic)
      asked_.reset();
  }
  Asked take() {
    return *std::exchange(asked_, {});
  }
  // Something else was said since.
  void interrupt() {
    asked_->interrupted = true;
  }
  // Without a slot to count at.
  std::uint32_t count_miss() {
    return ++asked_->missed;
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive.without(context_, output_, frames_, words_);
    archive(asked_);
  }

private:
  void ask_confirmation(TopicId topic, SlotId slot, TurnId turn);
  void unmark(TopicId topic);

  DialogueContext& context_;
  OutputManager& output_;
  TopicFrames& frames_;
  TopicWords& words_;
  std::optional<Asked> asked_;
};

} // namespace parlour::dialogue
