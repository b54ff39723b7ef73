#include "adapters/nlu/acts/parts_of_values.hpp"

#include <algorithm>
#include <cstdint>

#include "adapters/nlu/text/negation.hpp"

namespace parlour::adapters::nlu {

namespace {

using Values = std::vector<std::uint32_t>;

Values common(const Values& left, Values right) {
  std::erase_if(right, [&](std::uint32_t value) {
    return std::ranges::find(left, value) == left.end();
  });
  return right;
}

bool overlap(const Span& span, std::uint32_t begin, std::uint32_t end) {
  return span.core < end && begin < span.end;
}

bool is_filled(const Span& span, const std::vector<BuiltAct>& acts) {
  return std::ranges::any_of(acts, [&](const BuiltAct& act) {
    return std::ranges::any_of(act.fills, [&](const Fill& fill) {
      return overlap(span, fill.begin, fill.end);
    });
  });
}

// "Not the red one": within its clause.
bool is_negated(const Span& span, const Utterance& utterance) {
  const auto& tokens = utterance.tokens.list;
  for (auto at = span.begin; at > 0 && tokens[at].before == Break::none; --at)
    if (is_not(tokens[at - 1].word) || tokens[at - 1].word == "no")
      return true;
  return false;
}

// In the value's own sentence, or all that another one says: "Geetha. Nair."
bool is_beside(const Span& span, const Fill& fill, const Utterance& utterance) {
  const auto own =
      stretch_of(utterance.tokens, {fill.begin, fill.end}, Break::sentence);
  const auto other =
      stretch_of(utterance.tokens, {span.begin, span.end}, Break::sentence);
  return own.begin == other.begin ||
         (!utterance.has_content(other.begin, span.core) &&
          !utterance.has_content(span.end, other.end));
}

} // namespace

void join_parts_of_values(std::vector<BuiltAct>& acts,
                          const Utterance& utterance, Spans& spans) {
  for (auto& act : acts)
    for (auto& fill : act.fills) {
      if (!fill.span || spans[*fill.span].values.size() < 2)
        continue;
      const auto entity = spans[*fill.span].entity;
      auto left = spans[*fill.span].values;
      for (const auto& other : spans.all()) {
        if (other.entity != entity || other.unmatched ||
            other.confidence < guessed_value || is_filled(other, acts) ||
            is_negated(other, utterance) || !is_beside(other, fill, utterance))
          continue;
        if (auto both = common(left, other.values); !both.empty())
          left = std::move(both);
      }
      if (left.size() < spans[*fill.span].values.size())
        fill.span = spans.with_values(*fill.span, std::move(left));
    }
}

} // namespace parlour::adapters::nlu
