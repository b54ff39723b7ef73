// Asked: a question that waits for the user's answer. Plain data. OpenQuestion
// keeps the one that is asked now, Confirmations those of all scripts that
// wait.
//
// Its words go through three stages: `pending` while the output queue has them,
// then `heard` when they were released, or neither when they were withdrawn.
// Only one that was heard can be answered.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "script/dialogue/agenda/output_queue.hpp"
#include "script/dialogue/agenda/step.hpp"
#include "script/program/program.hpp"

namespace parlour::dialogue {

// The field `purpose` says what it is about, and so which other fields count.
struct Asked {
  enum class For : std::uint8_t {
    value,        // of a slot
    confirmation, // of a slot's value
    choice,       // between candidates
    yes_or_no,    // a script's <confirm>
    resume,       // whether to go on with a topic
    which_topic,  // that an act is about
    truth,        // of a slot that is yes or no
    more,         // whether there are further values of a slot
    change,       // what of the topic is to be another
  };
  For purpose = For::value;
  TopicId topic = script::no_id;
  SlotId slot = script::no_id;
  // Of a <confirm>: the wait and the body of its activation, the words to ask
  // again with, the slot that it is about, and whether it is being made anew.
  WaitId wait = 0;
  CodeId body = script::no_code;
  std::string question;
  SlotId about = script::no_id;
  bool anew = false;
  bool summary = false; // of all slots; its words are made when it is asked

  // Of a handler that asks about what the user said: the question before, which
  // that may answer.
  std::shared_ptr<const Asked> before;

  // Of which_topic: what the user said before, which the answer completes.
  std::shared_ptr<const Act> act;
  TurnId turn = 0; // in which it was asked
  // How many levels of states there were when it was asked: below a pushed
  // state it is not answered.
  std::size_t level = 0;
  OutputId output = 0;
  // The words as they were released; for a yes or no, the understanding gets
  // them, too.
  std::string words;
  bool pending = true;      // still in the output queue
  bool heard = false;       // released; with neither, it was withdrawn
  bool repeats = false;     // the same words again: not another question
  bool interrupted = false; // something else was said since
  // Times in a row that it was not answered, where there is no slot to count
  // at.
  std::uint32_t missed = 0;

  template <class Archive>
  void serialize(Archive& archive) {
    archive.up_to(purpose, For::change);
    archive.slot(topic, slot);
    archive.slot_of(topic, about);
    archive.code(body);
    archive(wait, question, anew, summary, before, act, turn, level, output,
            words, pending, heard, repeats, interrupted, missed);
  }

  // Whether a slot may be named that is to be another: "the day".
  bool asks_for_changes() const {
    return heard && (purpose == For::change || summary);
  }
  // Whether "yes" and "no" are answers to it.
  bool wants_yes_or_no() const {
    return purpose == For::yes_or_no || purpose == For::confirmation ||
           purpose == For::resume || purpose == For::truth ||
           purpose == For::more;
  }
  // Whether a slot is asked for, in wordings that take turns: its release is
  // counted at the slot.
  bool asks_for_value() const {
    return purpose == For::value || purpose == For::truth ||
           purpose == For::more;
  }
};

// One that words asked which others have said, such as the <speak> of a slot's
// <ambiguous>: it counts as heard.
inline Asked asked_by_others(Asked::For purpose, TopicId topic, SlotId slot,
                             TurnId turn = 0) {
  Asked asked;
  asked.purpose = purpose;
  asked.topic = topic;
  asked.slot = slot;
  asked.turn = turn;
  asked.pending = false;
  asked.heard = true;
  return asked;
}

} // namespace parlour::dialogue
