// Asked: a question that waits for the user's answer. Plain data.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "script/dialogue/agenda/output_queue.hpp"
#include "script/dialogue/agenda/step.hpp"
#include "script/program/program.hpp"

namespace parlour::dialogue {

struct Asked {
  enum class For : std::uint8_t {
    value,        // of a slot
    confirmation, // of a slot's value
    choice,       // between candidates
    yes_or_no,    // a script's <confirm>
    resume,       // whether to go on with a topic
    which_topic,  // that an act is about
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

  // Of a handler that asks about what the user said: the question before, which
  // that may answer.
  std::shared_ptr<const Asked> before;

  std::shared_ptr<const Act> act; // which_topic: what was said
  TurnId turn = 0;                // in which it was asked
  std::size_t level = 0;          // of pushed states, then
  OutputId output = 0;
  std::string words;        // that were heard
  bool pending = true;      // still in the output queue
  bool heard = false;       // released; with neither, it was withdrawn
  bool repeats = false;     // the same words again: not another question
  bool interrupted = false; // something else was said since
  std::uint32_t missed = 0; // times in a row, where there is no slot to count

  template <class Archive>
  void serialize(Archive& archive) {
    archive.up_to(purpose, For::which_topic);
    archive.slot(topic, slot);
    archive.slot_of(topic, about);
    archive.code(body);
    archive(wait, question, anew, before, act, turn, level, output, words,
            pending, heard, repeats, interrupted, missed);
  }

  bool wants_yes_or_no() const {
    return purpose == For::yes_or_no || purpose == For::confirmation ||
           purpose == For::resume;
  }
};

// One that words asked which others have said.
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
