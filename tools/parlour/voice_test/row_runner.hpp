// Holds a conversation by text or by voice and notes what came of each row of
// user's lines: what was heard, understood and answered. Unlike
// conversation_runner it compares nothing with the file: a run by voice is
// compared with the run by text.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tools/parlour/application/application.hpp"
#include "tools/parlour/conversation_test/conversation_file.hpp"
#include "tools/parlour/voice_test/kept_component.hpp"
#include "tools/parlour/voice_test/speech_bank.hpp"
#include "tools/parlour/voice_test/turn_log.hpp"

namespace parlour::tools {

// `U:` lines that follow each other, and what came of them.
struct Row {
  std::uint32_t line = 0; // of the first, in the file
  std::vector<std::string> said;
  std::vector<std::string> heard; // by voice only
  std::vector<std::string> understood;
  std::vector<std::string> answers;
  std::vector<Latency> latencies; // by voice only

  // Whether it was understood and answered like this one.
  bool is_as(const Row& other) const {
    return understood == other.understood && answers == other.answers;
  }
};

struct RowsHeld {
  std::vector<Row> rows;
  std::string trouble; // why the application did not start; usually empty
};

// Why a conversation cannot be held by voice; empty if it can. Pure.
std::string unspeakable(const Conversation& conversation);

// By text, in virtual time.
RowsHeld hold_by_text(const Application& application,
                      const Conversation& conversation);

// How lines are spoken.
struct Speaking {
  const SpeechBank* bank = nullptr; // has all lines
  std::string voice;
  adapters::Sound noise; // behind all; may be empty
  // Whether the recogniser knows what users say in the application's
  // conversations, as it does in a run.
  bool told = false;
  // Where recognisers are kept for the next conversation; null: each has one of
  // its own.
  KeptComponents* recognisers = nullptr;
};

// By voice, in virtual time. `application` has a voice seat with files as
// microphone and speaker (add_voice), which are replaced. The first `typed`
// rows are entered as text; then the conversation goes on until a row differs
// from that of `expected`, or until its end.
RowsHeld hold_by_voice(const Application& application,
                       const Conversation& conversation,
                       const Speaking& speaking,
                       const std::vector<Row>& expected, std::size_t typed);

} // namespace parlour::tools
