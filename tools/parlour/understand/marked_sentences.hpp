// Sentences whose meaning is marked, one a line, as JSON:
//
//  {"text": "a cab at six", "topic": "Taxi", "slots": {"Time": "06:00"}}
//  {"text": "yes", "act": "confirm"}
//  {"text": "what is the weather like"}
//  {"text": "six", "topic": "Taxi", "slots": {"Time": "06:00"},
//   "context": {"asked": {"topic": "Taxi", "slot": "Time"}}}
//
// Without topic and act a sentence is about nothing that the application knows.
// "intent" is another name of "topic". Other keys mean nothing.
#pragma once

#include <cstdint>
#include <istream>
#include <string>
#include <vector>

#include "runtime/base/error.hpp"
#include "runtime/base/value.hpp"

namespace parlour::tools {

struct MarkedSentence {
  std::uint32_t line = 0;
  std::string text;
  std::string topic; // empty: none
  std::string act;   // empty: any
  Map slots;         // name -> value
  Map context;
};

// The meaning, in a word: topic, act, or "nothing".
std::string intent_of(const MarkedSentence& sentence);

// Blank lines are left out. The error, of kind File, has the line.
Expected<std::vector<MarkedSentence>>
read_marked_sentences(std::istream& in, const std::string& file);

} // namespace parlour::tools
