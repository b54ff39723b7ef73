// Answers: what the user says while a handler waits for him, by <confirm> or
// <push>, and would get the same handler again. It is looked at for an answer
// first: a yes or no, an act that the pushed state listens to, or a wish to get
// out. That goes straight to who waits; all else goes its usual way. Words have
// to be understood for it. For example, a handler of ASR.RecognitionResult asks
// "Did you say Jeffery?" and waits. "Yes" would be given to the same handler as
// new words. Here it is sent to NLU first; the act `confirm` that comes back
// goes to the <confirm>. "No, to Ho" is more than an answer: those words go to
// the handler, which may ask anew (language rule 12.16).
#pragma once

#include <map>
#include <optional>

#include "script/dialogue/agenda/step_list.hpp"
#include "script/dialogue/context/inbox.hpp"
#include "script/dialogue/context/input.hpp"
#include "script/dialogue/context/messenger.hpp"
#include "script/dialogue/topic_engine/topic_engine.hpp"

namespace parlour::dialogue {

// Works for the Pipeline alone.
class Answers {
public:
  Answers(DialogueContext& context, Messenger& messenger, Inbox& inbox,
          const TopicEngine& topics)
      : context_(context), messenger_(messenger), inbox_(inbox),
        topics_(topics) {}

  // The acts of an answer, for the dialogue lane; an empty list where the words
  // are to be understood first: they are kept here then. In both cases the turn
  // was let go for the message, and nothing else is to be done about it.
  // Nothing: the message is not taken and goes on as it is.
  std::optional<StepList> take(Input& input);
  // The same for what the understanding makes of such words; if it is no
  // answer, the words go on.
  std::optional<StepList> take_meaning(Input& input);

  // The understanding of this turn's words never came: they are dropped, and
  // the turn counts as not understood.
  void forget(TurnId turn);
  void clear() {
    words_.clear();
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive.without(context_, messenger_, inbox_, topics_);
    archive(words_);
  }

private:
  // A frame list of the role NLU.
  bool is_meaning(const Message& message) const;
  // Its acts, if scripts wait for all of them; the turn is then held by each of
  // them and no longer by the message.
  std::optional<StepList> answer(const Input& input);

  DialogueContext& context_;
  Messenger& messenger_;
  Inbox& inbox_;
  const TopicEngine& topics_;
  std::map<Correlation, Input> words_; // that are being understood
};

} // namespace parlour::dialogue
