// SaidBeside: what the same utterance says beside a yes or no: more of the same
// answer, its opposite, or something else that is wanted (engine rule 5.8).
#pragma once

#include <functional>

#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/open_question.hpp"
#include "script/dialogue/context/topic_frames.hpp"
#include "script/dialogue/questions/whereabouts.hpp"

namespace parlour::dialogue {

// Whether more than a courtesy is ahead: "send it to Anna, no, wait". `ahead`
// is what the running item of the lane still has to do.
bool has_wish(const StepList& ahead);

// It reads, and changes, what the lane still has of the utterance: acts that
// are part of the answer are taken out, so that they do nothing by themselves.
// An act that is taken out lets its turn go. YesOrNo calls it, and only while a
// question waits.
class SaidBeside {
public:
  SaidBeside(DialogueContext& context, TopicFrames& frames,
             OpenQuestion& question, Whereabouts& whereabouts)
      : context_(context), frames_(frames), question_(question),
        whereabouts_(whereabouts) {}

  // Both may hold; a wish counts first.
  struct Reading {
    bool contradicts = false; // a no beside a yes
    bool wishes = false;      // something that comes before the answer
  };
  // What the acts ahead are to this answer to the question that waits. Further
  // answers are taken out of the lane.
  // To be called once for an answer: what it finds is gone afterwards.
  Reading read(const Act& answer);
  // So is what only says again what is asked.
  void drop_echoes();
  // Anything else that is wanted becomes an item of its own.
  void set_wishes_aside();

private:
  Reading judge(const Act& answer) const;
  // Takes the acts for which `wanted` holds out of the lane.
  void drop(const std::function<bool(const Act&)>& wanted);
  // The act asks for the very <repair> whose <confirm> is answered.
  bool echoes(const Act& act) const;
  // The act is about the topic of the question.
  bool is_about_it(const Act& act) const;
  // Each value of the act is the slot's value already, so nothing would change.
  bool says_the_same(const Act& act) const;

  DialogueContext& context_;
  TopicFrames& frames_;
  OpenQuestion& question_;
  Whereabouts& whereabouts_;
};

} // namespace parlour::dialogue
