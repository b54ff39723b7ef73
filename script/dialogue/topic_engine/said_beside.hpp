// SaidBeside: what the same utterance says beside a yes or no: more of the same
// answer, its opposite, or something else that is wanted (engine rule 5.8).
#pragma once

#include <functional>

#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/open_question.hpp"
#include "script/dialogue/context/topic_frames.hpp"
#include "script/dialogue/questions/whereabouts.hpp"

namespace parlour::dialogue {

class SaidBeside {
public:
  SaidBeside(DialogueContext& context, TopicFrames& frames,
             OpenQuestion& question, Whereabouts& whereabouts)
      : context_(context), frames_(frames), question_(question),
        whereabouts_(whereabouts) {}

  struct Reading {
    bool contradicts = false; // a no beside a yes
    bool wishes = false;      // something that comes before the answer
  };
  // What the acts ahead are to this answer to the question that waits. Further
  // answers are taken out of the lane.
  Reading read(const Act& answer);
  // So is what only says again what is asked.
  void drop_echoes();
  // Anything else that is wanted becomes an item of its own.
  void set_wishes_aside();

private:
  Reading judge(const Act& answer) const;
  void drop(const std::function<bool(const Act&)>& wanted);
  bool echoes(const Act& act) const;
  bool is_about_it(const Act& act) const;
  bool says_the_same(const Act& act) const;

  DialogueContext& context_;
  TopicFrames& frames_;
  OpenQuestion& question_;
  Whereabouts& whereabouts_;
};

} // namespace parlour::dialogue
