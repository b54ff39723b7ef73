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

struct SlotValue {
  std::string slot;
  Value value;
  Value confidence;
  std::string text;
  List candidates;
  bool unmatched = false;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(slot, value, confidence, text, candidates, unmatched);
  }
};

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
    archive.up_to(kind, ActKind::person);
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
// About the conversation itself: help, repeat, cancel, greet …
bool is_generic(const Act& act);

using ActPointer = std::shared_ptr<const Act>;

struct ParsedActs {
  std::vector<Act> acts;
  std::vector<std::string> problems; // a sentence each
};

ParsedActs parse_acts(const Value& frames);

// The same act as a map, for messages of source Dialogue and for NLU contexts.
Value to_value(const Act& act);

} // namespace parlour::dialogue
