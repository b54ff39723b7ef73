// TopicEffects: what scripts want of states and topics, and what they say. Most
// of it happens when the activation ends or waits (engine rule 2.3).
#pragma once

#include <string>

#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/running_script.hpp"
#include "script/dialogue/context/topic_frames.hpp"
#include "script/dialogue/output/output_manager.hpp"
#include "script/dialogue/questions/confirmations.hpp"
#include "script/dialogue/questions/repair_runner.hpp"
#include "script/dialogue/questions/topic_words.hpp"
#include "script/program/host.hpp"

namespace parlour::dialogue {

// Keeps nothing. What is wanted later becomes a step of the RunningScript;
// words, slots and registration change at once.
class TopicEffects {
public:
  using Performed = script::Performed;
  using Call = const script::Effect&;
  using Context = const script::ActivationContext&; // of the script

  TopicEffects(DialogueContext& context, TopicFrames& frames,
               RunningScript& running, OutputManager& output, TopicWords& words,
               Confirmations& confirmations, RepairRunner& repairs)
      : context_(context), frames_(frames), running_(running), output_(output),
        words_(words), confirmations_(confirmations), repairs_(repairs) {}

  // -- states --
  // An error of kind Range where there is no such state; push(), too.
  Performed transit(Context context, Call effect);
  // The script waits until the state is popped.
  Performed push(Context context, Call effect);
  Performed pop(Context context);

  // -- topics --
  Performed activate(Context context, Call effect);
  Performed reset(Context context, Call effect);
  Performed complete(Context context, Call effect);
  Performed cancel(Context context, Call effect);
  Performed ask(Context context, Call effect);
  // The script waits for yes (true) or no (false); unknown: it is to ask anew.
  // The same for summarise(), about all slots.
  Performed confirm(Context context, Call effect);
  Performed summarise(Context context, Call effect);
  // What of the topic is to be another, after a no to its summary.
  Performed ask_change(Context context);
  Performed clear(Context context, Call effect);
  Performed register_topic(Call effect);

  // -- words --
  Performed speak(Context context, Call effect);
  // A phrase, by its act.
  Performed say(Context context, Call effect);
  Performed repeat(Context context);

  // `this.X` is set: at once, as the next statement may read it. What the
  // topic's scripts have asked is asked anew.
  void set_slot(TopicId topic, SlotId slot, Value value);

private:
  // About the topic that it names, else the own one.
  template <class Kind>
  Performed later(Context context, Call effect, Kind step);
  // The same, where there must be one.
  template <class Kind>
  Performed later_of_topic(Context context, Call effect, Kind step);
  Performed ask_slot(Context context, Call effect);
  // What operand 0 names; no_id where there is none.
  StateId state_of(Call effect) const;
  TopicId topic_of(Call effect) const;
  SlotId slot_of(TopicId topic, const std::string& name) const;

  DialogueContext& context_;
  TopicFrames& frames_;
  RunningScript& running_;
  OutputManager& output_;
  TopicWords& words_;
  Confirmations& confirmations_;
  RepairRunner& repairs_;
};

} // namespace parlour::dialogue
