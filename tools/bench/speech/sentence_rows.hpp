// The rows of `parlour bench speech` that say lines by themselves: names,
// sentences that belong and foreign ones, and numbers by real people.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "tools/bench/speech/listener.hpp"
#include "tools/bench/speech/sentences.hpp"
#include "tools/parlour/voice_test/speech_bank.hpp"

namespace parlour::tools {

// What became of a name that was said.
enum class NameOutcome : std::uint8_t { right, asked, wrong, nothing };

// Of the acts that follow "I am here to meet NAME.": right if the name alone
// was understood, asked if it is one of several candidates.
NameOutcome name_outcome(const List& acts, const std::string& name);

// All of them say how a line cannot be heard, and then give false. `trace`:
// each line is printed, with what was heard.
struct SentenceRows {
  Listener& listener;
  SpeechBank& bank;
  std::vector<std::string> voices;
  bool trace = false;
  std::ostream& out;

  bool names(const std::vector<std::string>& names);
  bool foreign(const Sentences& sentences);
  bool digits(const std::filesystem::path& data,
              const std::vector<std::string>& speakers);
};

} // namespace parlour::tools
