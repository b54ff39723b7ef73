// TurnLog: which numbered turns a session has taken and answered, and what it
// said last: after a crash whoever talks with it is told what he may not have
// heard (engine rule 7.11). Only who numbers his turns (engine rule 7.1) has
// numbers here; for all others both counts stay 0, and `said` alone counts.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "script/dialogue/agenda/output_queue.hpp"
#include "script/dialogue/inputs/session_input.hpp"

namespace parlour::dialogue {

// Kept beside the conversation, by the same inputs, and saved with each state
// in the journal.
struct TurnLog {
  struct Said {
    std::uint64_t turn = 0; // that it answers; 0: said without being asked
    // The OutputId, by which the one who is told can see that he has it.
    std::uint64_t output = 0;
    OutputAct act = OutputAct::answer;
    std::string text;
  };

  std::uint64_t taken = 0; // the highest number; 0: turns have none
  std::uint64_t done = 0;  // those up to this one are answered
  // Since the user began to speak last; the newest 64, if there are many.
  std::vector<Said> said;

  // In the order in which things happen: an input comes, its outputs leave, it
  // is dealt with. Whoever feeds the conversation calls all three, for every
  // input.
  void take(const SessionInput& input);
  void release(const Output& output);
  void dealt_with(const Conversation& conversation, Timestamp now);
};

} // namespace parlour::dialogue
