// RepairRunner: which <repair> of the program is run, and what it sees (engine
// rule 5).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/open_question.hpp"
#include "script/dialogue/context/text_evaluator.hpp"
#include "script/dialogue/context/topic_frames.hpp"
#include "script/dialogue/questions/confirmations.hpp"
#include "script/dialogue/questions/whereabouts.hpp"

namespace parlour::dialogue {

// What the conversation has run into, for a <repair>.
struct Trouble {
  std::string_view act; // of the user; no_match, no_input
  TopicId topic = script::no_id;
  SlotId slot = script::no_id;
  std::uint32_t count = 0;
  TurnId turn = 0;
  bool refused = false;  // understood, and does not fit
  bool answered = false; // the question was, and more may follow
};

// RepairActs and Reprompts tell it what has happened; which <repair> that means
// is the pure choose_repair (topics/repairs.hpp). The <repair> itself is
// script, run by a step, so it may ask, wait or leave like any other.
class RepairRunner {
public:
  RepairRunner(DialogueContext& context, TopicFrames& frames,
               TextEvaluator& texts, OpenQuestion& question,
               Whereabouts& whereabouts)
      : context_(context), frames_(frames), texts_(texts), question_(question),
        whereabouts_(whereabouts) {}

  // The <repair> that is due for it is run, in front of all other steps; false
  // where there is none. Its condition is computed now, with `data`.
  bool repair(const Trouble& trouble);
  // What a phrase of that act sees where a script's <say> gives no data;
  // unknown where the act needs none.
  Value data_of(const std::string& act, TopicId topic, SlotId slot);

  // Without a question being asked, what was said made sense, or did not.
  void understood() {
    misses_ = 0;
  }
  void missed() {
    ++misses_;
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive.without(context_, frames_, texts_, question_, whereabouts_);
    archive(misses_);
  }

private:
  // Made for each trouble: its conditions read it, and its body as `data`.
  Value situation(const Trouble& trouble);

  DialogueContext& context_;
  TopicFrames& frames_;
  TextEvaluator& texts_;
  OpenQuestion& question_;
  Whereabouts& whereabouts_;
  std::uint32_t misses_ = 0; // not understood in a row, nothing being asked
};

} // namespace parlour::dialogue
