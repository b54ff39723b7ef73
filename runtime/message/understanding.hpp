// The understanding model: what a language understanding component needs to
// know of an application, as data (docs/understanding.md): topics with their
// slots, sets of values, grammars and examples. The compiler makes it; it is
// immutable and shared by all readers.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "runtime/base/error.hpp"
#include "runtime/base/value.hpp"

namespace parlour {

// A slot as understanding sees it.
struct SlotModel {
  std::string name;
  std::string type; // cardinality: "set", "time", "level", … or ""; "part":
                    // no words fill it
  std::vector<std::string> values; // of a set, canonical forms
  std::string source;              // of a query: "db:table.column", else ""
  bool functional = false;
  bool relevant_to_query = false; // used by a <by> of the topic's query
  bool many = false;              // several values of it are said in one act
  // The bounds of a range that are written as whole numbers, else 0 and 0.
  std::int64_t least = 0;
  std::int64_t most = 0;

  bool operator==(const SlotModel&) const = default;
};

struct TopicModel {
  std::string name;
  bool enquiry = false;
  std::vector<SlotModel> slots;
  std::vector<std::string> examples; // such as "I am [David](Visitor)"
  bool part = false;                 // spoken about only while it goes on

  bool operator==(const TopicModel&) const = default;
};

// JSGF text of a <grammar> element or a file.
struct GrammarModel {
  std::string name;
  std::string text;
  SourceLocation place; // of the text's first line, for its findings

  bool operator==(const GrammarModel&) const = default;
};

// How a word sounds, in the phones of a recogniser: "HH OW".
struct PronunciationModel {
  std::string word;
  std::string phones;

  bool operator==(const PronunciationModel&) const = default;
};

struct UnderstandingModel {
  std::vector<TopicModel> topics;
  std::vector<GrammarModel> grammars;
  std::vector<PronunciationModel> pronunciations = {};

  bool operator==(const UnderstandingModel&) const = default;
};

// Reads the values of a database column ("db:rr_staff.staff_name") for a set of
// values. May block; called while the application loads. What changes later is
// told by the database (Database.ValuesChanged).
using ColumnReader =
    std::function<Expected<std::vector<std::string>>(const std::string&)>;

// An act, as an entry of a list of frames (engine rule 5.2), is a map with
// these keys:
//   topic        string, or unknown if the engine's classifier is to choose
//   act          "inform" "request" "confirm" "deny" "correct" "help" "wait"
//                "repeat" "cancel" "restart" "greet" "bye" "thank" "protest"
//                "explain" "options" "rephrase" "abandon" "person" "refuse"
//   confidence   0..1 or unknown
//   slots        map: name -> value, or {value, confidence, text, candidates};
//                of several values {items}: a list of such, each with its
//                `amount`; `more`: so many in addition; `unmatched`: true if
//                the words are where a value belongs and are none; `heard`:
//                true if they only sound like the value. Words that are
//                unmatched and have no value name the slot itself: "the day"
//   text         the words
//   elliptical   boolean
//   alternatives list of acts, on the first act only
// If several values match equally well, `candidates` lists them and `value` is
// unknown.
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
inline constexpr const char* items = "items";
inline constexpr const char* amount = "amount";
inline constexpr const char* more = "more";
inline constexpr const char* unmatched = "unmatched";
inline constexpr const char* heard = "heard";
} // namespace act_key

// The session's context, the second parameter of DoNLU, is a map: asked
// ({topic, slot} or unknown), waiting (the same, of the topic that an aside has
// suspended, where nothing is asked), said (its slots that were given before,
// the latest last), current and resting topic, unfinished (a list of topics),
// completed (the task that was completed last), choices (a list: what is
// offered), confirms (the words of the yes-or-no question that was asked),
// changes ({topic, slots: name -> label} of which it was asked whether they are
// right), grammar (or unknown), heard (a list of texts: what else a recogniser
// may have heard; unknown: the words were typed), and now (in ms).

} // namespace parlour
