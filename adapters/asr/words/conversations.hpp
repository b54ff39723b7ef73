// What users say in the conversations of an application (its tests in
// dialogues/), and the values that are then expected in slots.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace parlour::adapters::asr {

// What people say there weighs more than what is drawn from the grammars
// (language.cpp).
struct Conversations {
  std::vector<std::string> lines;
  // Topic.Slot and its value.
  std::vector<std::pair<std::string, std::string>> values;

  bool operator==(const Conversations&) const = default;
};

// Adds what the text of one conversation has.
void read_conversation(std::string_view text, Conversations& to);

// Of all files *.txt of a folder, in order of their names; none if it cannot be
// read. Bounded: the first 10,000 lines.
Conversations read_conversations(const std::filesystem::path& folder);

} // namespace parlour::adapters::asr
