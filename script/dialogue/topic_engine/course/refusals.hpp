// Refusals: a no on the way to a topic's completion never leads there (language
// rule 12.21).
#pragma once

#include <cstdint>
#include <vector>

#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/running_script.hpp"
#include "script/dialogue/context/topic_frames.hpp"
#include "script/dialogue/output/output_manager.hpp"
#include "script/dialogue/questions/confirmations.hpp"

namespace parlour::dialogue {

// A no on the way to a topic's completion: to a <confirm> of its own script, or
// to a value in doubt. The topic does not get there by itself.
struct Refusal {
  TopicId topic = script::no_id;
  CodeId body = script::no_code; // of the script; or no_code
  SlotId slot =
      script::no_id;       // whose value, or whose <filled>, it is; or no_id
  Value value;             // of that slot
  std::uint64_t told = 0;  // how much had been told before
  std::uint64_t deeds = 0; // and done, by scripts

  template <class Archive>
  void serialize(Archive& archive) {
    archive.slot(topic, slot);
    archive.code(body);
    archive(value, told, deeds);
  }
};

// Scripts run to their end whatever the user has said, so nothing stops at a
// no. It is noted here instead, and looked at where the topic would be
// completed: Settling and Enquiries take what was noted about their topic. A no
// that the script itself has dealt with (<clear>, <ask>, <transit> …) counts no
// more.
class Refusals {
public:
  Refusals(DialogueContext& context, RunningScript& running,
           OutputManager& output, TopicFrames& frames,
           Confirmations& confirmations)
      : context_(context), running_(running), output_(output), frames_(frames),
        confirmations_(confirmations) {}

  // A script of the topic ended with an error, or heard a no: the topic is not
  // completed after all, where the script leads there. Bodies that lead nowhere
  // and no_id are no matter.
  void body_failed(TopicId topic, CodeId body);
  void note_no(TopicId topic, CodeId body);
  // What its scripts were refused and have not dealt with themselves.
  // They are forgotten here, those that were dealt with too. In the order in
  // which they came.
  std::vector<Refusal> take_refusals(TopicId topic);
  // A refused value is taken back. True: the topic is being cancelled instead
  // of completed, by a step in front of all others; the caller does nothing
  // more with it.
  bool heeds_refusals(TopicId topic, TurnId turn);
  // The user said no to a value in doubt, which is still in the frame: a topic
  // that would be completed with the one before asks.
  void doubt_earlier_value(TopicId topic, SlotId slot);

  void clear() {
    refusals_.clear();
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive.without(context_, running_, output_, frames_, confirmations_);
    archive(refusals_);
  }

private:
  void note_refusal(TopicId topic, CodeId body, std::uint64_t told);
  bool is_dealt_with(const Refusal& refusal) const;
  bool gives_up(const Refusal& refusal) const;

  DialogueContext& context_;
  RunningScript& running_;
  OutputManager& output_;
  TopicFrames& frames_;
  Confirmations& confirmations_;
  std::vector<Refusal> refusals_; // that a topic has not settled with yet
};

} // namespace parlour::dialogue
