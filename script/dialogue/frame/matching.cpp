#include "script/dialogue/frame/matching.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <re2/re2.h>

#include "script/dialogue/frame/normal_form.hpp"
#include "script/dialogue/frame/spelling.hpp"

namespace parlour::dialogue {

namespace {

bool contains(const List& list, const Value& value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

// One value is the value; several are candidates; none does not fit.
Matched one_of(List values) {
  if (values.size() == 1)
    return {std::move(values.front()), {}};
  return {{}, std::move(values)};
}

// Whether a text is the same as what was said but for case and spaces.
class SameWords {
public:
  explicit SameWords(const Value& said)
      : text_(said.text()), words_(folded(text_)) {}

  bool operator()(std::string_view written) const {
    if (words_.empty())
      return written == text_;
    return written == words_ || // as sets are mostly written
           (written.size() >= words_.size() && folds_to(written, words_));
  }

private:
  std::string text_;
  std::string words_;
};

// The options that are the same but for case and spaces.
List same(const Value& said, const List& options) {
  const SameWords is_same(said);
  List found;
  for (const auto& option : options) {
    const auto* string = option.if_string();
    if ((string ? is_same(*string) : is_same(option.text())) &&
        !contains(found, option))
      found.push_back(option);
  }
  return found;
}

// The same, of a set of constant texts, made values only where they fit;
// nothing where the set has other values.
std::optional<List> same_constants(const Value& said,
                                   const script::Cardinality& cardinality,
                                   const CardinalityEvaluator& evaluate) {
  const SameWords is_same(said);
  List found;
  for (auto code : cardinality.values) {
    const auto text = evaluate.constant(code);
    if (!text)
      return std::nullopt;
    if (is_same(*text) && !contains(found, *text))
      found.emplace_back(*text);
  }
  return found;
}

// The options nearest in spelling; of equally near ones all.
// What is the same but for case and spaces wins against everything that is only
// near, so that a long set need not be compared letter by letter.
List nearest(const Value& said, const List& options) {
  auto found = same(said, options);
  if (!found.empty())
    return found;
  int best = 0;
  for (const auto& option : options) {
    auto distance = spelling_distance(said.text(), option.text());
    if (!distance || (!found.empty() && *distance > best) ||
        contains(found, option))
      continue;
    if (!found.empty() && *distance < best)
      found.clear();
    best = *distance;
    found.push_back(option);
  }
  return found;
}

// A value that is a list (an expr) stands for its elements.
List set_values(const script::Cardinality& cardinality,
                const CardinalityEvaluator& evaluate) {
  List values;
  values.reserve(cardinality.values.size());
  for (auto code : cardinality.values) {
    auto value = evaluate(code);
    if (value && value->if_list())
      values.insert(values.end(), value->if_list()->begin(),
                    value->if_list()->end());
    else if (value && !value->is_unknown())
      values.push_back(*value);
  }
  return values;
}

Value bound(CodeId code, const CardinalityEvaluator& evaluate) {
  if (code == script::no_code)
    return {};
  auto value = evaluate(code);
  return value ? *value : Value();
}

// What a range's bounds are tells what its values are.
// The first type of which both bounds have the normal form; a bound that is
// left out fits any. Empty: there is none, and no value is in the range.
std::string_view range_type(const Value& low, const Value& high) {
  for (const auto* type : {"number", "time", "date"})
    if ((low.is_unknown() || !normal_form(type, low).is_unknown()) &&
        (high.is_unknown() || !normal_form(type, high).is_unknown()))
      return type;
  return {};
}

// Normal forms of times and dates have a fixed length, so they are in order as
// texts. A bound that is unknown is no bound.
bool in_order(const Value& low, const Value& high) {
  if (low.is_unknown() || high.is_unknown())
    return true;
  if (low.if_string()) // times and dates in normal form
    return low.text() <= high.text();
  return low.number_or(0) <= high.number_or(0);
}

Value in_range(const script::Cardinality& cardinality, const Value& said,
               const CardinalityEvaluator& evaluate) {
  const auto low = bound(cardinality.minimum, evaluate);
  const auto high = bound(cardinality.maximum, evaluate);
  const auto type = range_type(low, high);
  auto value = normal_form(type, said);
  const bool inside = !value.is_unknown() &&
                      in_order(normal_form(type, low), value) &&
                      in_order(value, normal_form(type, high));
  return inside ? value : Value();
}

// A pattern that RE2 cannot read takes nothing.
Value by_pattern(const std::string& pattern, const Value& said) {
  RE2 expression(pattern, RE2::Quiet);
  return expression.ok() && RE2::FullMatch(said.text(), expression) ? said
                                                                    : Value();
}

bool is_empty(const Value& value) {
  return value.is_unknown() ||
         (value.if_string() && folds_to(*value.if_string(), {}));
}

// Most sets are constant texts and most answers one of them, so these are
// compared first, without a value for each. Only then are the values computed,
// and spellings compared.
Matched match_set(const script::Cardinality& cardinality, const Value& said,
                  const CardinalityEvaluator& evaluate) {
  auto found = same_constants(said, cardinality, evaluate);
  if (!found || found->empty())
    found = nearest(said, set_values(cardinality, evaluate));
  return one_of(std::move(*found));
}

Matched match_said(const script::Slot& slot, const Value& said, bool unmatched,
                   const CardinalityEvaluator& evaluate) {
  const auto& cardinality = slot.cardinality;
  if (said.is_unknown())
    return {};
  if (cardinality.type == "set")
    return match_set(cardinality, said, evaluate);
  if (cardinality.type == "range")
    return {in_range(cardinality, said, evaluate), {}};
  if (cardinality.type == "pattern")
    return {by_pattern(cardinality.pattern, said), {}};
  // Only the understanding knows a query's values; what it found to be none
  // of a normal form is none.
  const bool formed = has_normal_form(cardinality.type);
  const bool refused = unmatched && (formed || cardinality.type == "query");
  if (formed && !refused)
    return {normal_form(cardinality.type, said), {}};
  return {refused || is_empty(said) ? Value() : said, {}};
}

} // namespace

Value said(const FrameChange& change) {
  if (change.value.is_unknown() && !change.text.empty())
    return change.text;
  return change.value;
}

Matched match(const script::Slot& slot, const FrameChange& change,
              const CardinalityEvaluator& evaluate) {
  if (!change.value.is_unknown() || change.candidates.empty())
    return match_said(slot, said(change), change.unmatched, evaluate);
  List fitting;
  for (const auto& candidate : change.candidates) {
    auto matched = match_said(slot, candidate, false, evaluate);
    if (!matched.value.is_unknown() && !contains(fitting, matched.value))
      fitting.push_back(matched.value);
  }
  return one_of(std::move(fitting));
}

Matched match_choice(const script::Slot& slot, const FrameChange& change,
                     const List& candidates,
                     const CardinalityEvaluator& evaluate) {
  List offered = change.candidates;
  if (!change.value.is_unknown())
    offered.insert(offered.begin(), change.value);
  List chosen;
  for (const auto& candidate : candidates)
    if (contains(offered, candidate))
      chosen.push_back(candidate);
  if (chosen.empty())
    chosen = nearest(said(change), candidates);
  if (chosen.empty())
    for (const auto& candidate : candidates)
      if (has_words(candidate.text(), said(change).text()))
        chosen.push_back(candidate);
  return chosen.empty() ? match(slot, change, evaluate)
                        : one_of(std::move(chosen));
}

} // namespace parlour::dialogue
