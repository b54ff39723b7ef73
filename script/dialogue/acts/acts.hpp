// Acts: what the user did with an utterance, as <fire> hands it over (engine
// rule 5, "Acts"; the keys are in runtime/message/understanding.hpp). Parsing
// never fails: what makes no sense is left out and counted in `problems`.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/value.hpp"
#include "runtime/message/act_kinds.hpp"

namespace parlour::dialogue {

using parlour::ActKind;

// What an act says about one slot. An act may have several of the same slot, if
// that takes several values. Either a value or candidates is known, or at least
// the words are.
struct SlotValue {
  std::string slot;
  Value value;
  Value confidence;
  std::string text;
  List candidates;
  bool unmatched = false;
  Value amount = {};  // of a slot with several values; unknown: not said
  bool more = false;  // so many in addition
  bool heard = false; // the words only sound like the value

  template <class Archive>
  void serialize(Archive& archive) {
    archive(slot, value, confidence, text, candidates, unmatched, amount, more,
            heard);
  }
};

// One thing that the user did with an utterance. Immutable once it is parsed:
// steps and questions share it.
struct Act {
  ActKind kind = ActKind::inform;
  std::string topic; // empty: for the classifier to choose
  Value confidence;
  std::vector<SlotValue> slots;
  std::string text;
  bool elliptical = false;
  std::vector<Act> alternatives;

  template <class Archive>
  void serialize(Archive& archive) {
    archive.up_to(kind, last_act_kind);
    archive(topic, confidence, slots, text, elliptical, alternatives);
  }
};

inline bool wants_out(const Act& act) {
  return act.kind == ActKind::cancel || act.kind == ActKind::abandon;
}
// Who wants out, or to start over, waits for nothing (engine rule 2).
inline bool passes_waits(const Act& act) {
  return wants_out(act) || act.kind == ActKind::restart;
}

// A yes or no: for what was asked, it begins no topic.
inline bool is_answer(const Act& act) {
  return act.slots.empty() &&
         (act.kind == ActKind::confirm || act.kind == ActKind::deny);
}
// Names a slot that is to be another: "the day", to "What should I change?".
bool names_slot(const Act& act);
// About the conversation itself: help, repeat, cancel, greet …
bool is_generic(const Act& act);

using ActPointer = std::shared_ptr<const Act>;

// The acts in the order in which they were said, and what was left out.
struct ParsedActs {
  std::vector<Act> acts;
  std::vector<std::string> problems; // a sentence each
};

// `frames` comes from a script, so it may be anything. An act is left out whole
// if its kind or its topic makes no sense, as it might be taken for another
// one; of slots and confidences only what is wrong is.
ParsedActs parse_acts(const Value& frames);

// The same act as a map, for messages of source Dialogue and for NLU contexts.
// parse_acts() of it gives the act again.
Value to_value(const Act& act);

} // namespace parlour::dialogue
