// Matching: from what was said for a slot to a value of its cardinality
// (engine rule 5, filling event (2)). Pure.
#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <utility>

#include "script/dialogue/frame/topic_frame.hpp"
#include "script/program/constant_text.hpp"
#include "script/program/program.hpp"

namespace parlour::dialogue {

// A value; or several candidates, equally near; or neither: it does not fit.
struct Matched {
  Value value;
  List candidates;

  explicit operator bool() const {
    return !value.is_unknown() || !candidates.empty();
  }
};

// Evaluates the values and bounds of a cardinality; knows which of them are
// texts that need no evaluation, where it was given the program.
class CardinalityEvaluator {
public:
  template <class Evaluate>
  CardinalityEvaluator(Evaluate evaluate,
                       const script::Program* program = nullptr)
      : evaluate_(std::move(evaluate)), program_(program) {}

  Expected<Value> operator()(CodeId code) const {
    return evaluate_(code);
  }
  std::optional<std::string_view> constant(CodeId code) const {
    return program_ ? script::constant_text(*program_, code) : std::nullopt;
  }

private:
  std::function<Expected<Value>(CodeId code)> evaluate_;
  const script::Program* program_; // may be null
};

// What the user said for the slot: the change's value, else its words; unknown
// where there is neither.
Value said(const FrameChange& change);

// The slot's cardinality decides; its candidates are matched one by one.
// "purpl" for a set of red and purple -> purple; "10:30am" for a time -> 10:30.
Matched match(const script::Slot& slot, const FrameChange& change,
              const CardinalityEvaluator& evaluate);

// The same where one of `candidates` was asked for ("Do you mean Ann Lee or Ann
// Ho?"): what narrows them down comes first, words that are part of one
// included ("Lee"). What is none of them is matched like any other value.
Matched match_choice(const script::Slot& slot, const FrameChange& change,
                     const List& candidates,
                     const CardinalityEvaluator& evaluate);

} // namespace parlour::dialogue
