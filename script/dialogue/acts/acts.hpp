// Acts: what the user did with an utterance, as <fire> hands it over (engine
// rule 5, "Acts"; the keys are in runtime/base/understanding.hpp). Parsing
// never fails: what makes no sense is left out and counted in `problems`.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/value.hpp"

namespace parlour::dialogue {

// clang-format off
#define PARLOUR_ACT_KINDS(X) \
  X(inform, "gives values") X(request, "wants to know") \
  X(confirm, "yes") X(deny, "no") X(correct, "mends a value") \
  X(help, "wants help") X(repeat, "wants to hear it again") \
  X(cancel, "wants to stop this") X(restart, "wants to start over") \
  X(greet, "hello") X(bye, "goodbye") X(thank, "thanks") \
  X(explain, "wants to know why it is asked") \
  X(options, "wants to know what can be said") \
  X(rephrase, "wants to hear it in other words") \
  X(abandon, "wants to stop everything") X(person, "wants somebody to talk to")
// clang-format on

enum class ActKind : std::uint8_t {
#define X(name, sentence) name,
  PARLOUR_ACT_KINDS(X)
#undef X
};

std::string_view name_of(ActKind kind);

struct SlotValue {
  std::string slot;
  Value value;
  Value confidence;
  std::string text;
  List candidates;
  bool unmatched = false;
};

struct Act {
  ActKind kind = ActKind::inform;
  std::string topic; // empty: for the classifier to choose
  Value confidence;
  std::vector<SlotValue> slots;
  std::string text;
  bool elliptical = false;
  std::vector<Act> alternatives;
};

inline bool wants_out(const Act& act) {
  return act.kind == ActKind::cancel || act.kind == ActKind::abandon;
}
// Who wants out, or to start over, waits for nothing (engine rule 2).
inline bool passes_waits(const Act& act) {
  return wants_out(act) || act.kind == ActKind::restart;
}

using ActPointer = std::shared_ptr<const Act>;

struct ParsedActs {
  std::vector<Act> acts;
  std::vector<std::string> problems; // a sentence each
};

ParsedActs parse_acts(const Value& frames);

// The same act as a map, for messages of source Dialogue and for NLU contexts.
Value to_value(const Act& act);

} // namespace parlour::dialogue
