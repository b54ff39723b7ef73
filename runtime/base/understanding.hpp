// What a language understanding component needs to know of an application, as
// data (understanding.md): topics with their slots, sets of values, grammars,
// examples. Made by the compiler, immutable, shared by all readers.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "runtime/base/error.hpp"
#include "runtime/base/value.hpp"

namespace parlour {

struct SlotModel {
  std::string name;
  std::string type; // cardinality: "set", "time", "level", … or ""
  std::vector<std::string> values; // of a set, canonical forms
  std::string source;              // of a query: "db:table.column", else ""
  bool functional = false;
  bool relevant_to_query = false; // a <by> uses it
};

struct TopicModel {
  std::string name;
  bool enquiry = false;
  std::vector<SlotModel> slots;
  std::vector<std::string> examples; // "I am [David](Visitor) …"
};

// JSGF text; a <grammar name> element or a file.
struct GrammarModel {
  std::string name;
  std::string text;
  Place place; // of the text's first line, so that errors can be placed
};

struct UnderstandingModel {
  std::vector<TopicModel> topics;
  std::vector<GrammarModel> grammars;
};

// Reads a column ("db:rr_staff.staff_name") for value sets. May block; called
// while loading and when told that the data changed.
using ColumnReader =
    std::function<Expected<std::vector<std::string>>(const std::string&)>;

// The frame list's entry for one act (engine rule 5) is a map with these keys:
//   topic        string, or unknown for the engine's classifier to choose
//   act          "inform" "request" "confirm" "deny" "correct" "help"
//                "repeat" "cancel" "restart" "greet" "bye" "thank"
//                "explain" "options" "rephrase" "abandon" "person"
//   confidence   0..1 or unknown
//   slots        map: name -> value, or {value, confidence, text, candidates}
//   text         the words
//   elliptical   boolean
//   alternatives list of acts, on the first act only
// A candidate list stands where several values match equally well; `value` is
// then unknown.
namespace act_key {
inline constexpr const char* topic = "topic";
inline constexpr const char* act = "act";
inline constexpr const char* confidence = "confidence";
inline constexpr const char* slots = "slots";
inline constexpr const char* text = "text";
inline constexpr const char* elliptical = "elliptical";
inline constexpr const char* alternatives = "alternatives";
inline constexpr const char* value = "value";
inline constexpr const char* candidates = "candidates";
} // namespace act_key

// The session's context, DoNLU's second parameter, is a map: asked {topic,
// slot} or unknown, said (slots of it given before, the latest last), current
// and resting topic, unfinished list of topics, grammar or unknown, now (ms).

} // namespace parlour
