#include "adapters/nlu/acts/act_value.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "adapters/nlu/acts/amounts.hpp"
#include "adapters/nlu/forms/number_words.hpp"
#include "adapters/nlu/parse/open_words.hpp"

namespace parlour::adapters::nlu {

namespace {

// Confidences are rounded so that they print well.
double in_thousandths(double confidence) {
  return std::round(confidence * 1000) / 1000;
}

// "Twelve", which is no telephone number, is no other than "12".
std::string figures_of(const Tokens& tokens, const Fill& fill,
                       const std::string& text) {
  const auto number = number_at(tokens, fill.begin);
  return number && !number->ordinal && !number->digits &&
                 fill.begin + number->length == fill.end
             ? std::to_string(number->value)
             : text;
}

Value fill_value(const Fill& fill, const Utterance& utterance,
                 const Spans& spans, const Schema& schema,
                 const BuiltAct& act) {
  const std::string text(
      words_of(utterance.text, utterance.tokens, fill.begin, fill.end));
  if (fill.is_name)
    return Map{{act_key::unmatched, true}, {act_key::text, text}};
  Map made{{act_key::value, text}, {act_key::confidence, 1.0}};
  if (fill.literal) {
    made.set(act_key::value, *fill.literal);
  } else if (fill.span) {
    const auto& span = spans[*fill.span];
    made.set(act_key::confidence, in_thousandths(span.confidence));
    if (is_form(span.entity) && !span.unmatched)
      made.set(act_key::value, span.value);
    if (span.unmatched) {
      made.set(act_key::unmatched, true);
      if (is_form(span.entity))
        made.set(act_key::value, figures_of(utterance.tokens, fill, text));
    }
    if (span.only_heard)
      made.set(act_key::heard, true);
    const auto set = span.entity - first_set_entity;
    List candidates;
    for (const auto value : span.values)
      candidates.push_back(schema.values().value(set, value));
    if (candidates.size() == 1)
      made.set(act_key::value, candidates[0]);
    else if (candidates.size() > 1) {
      made.set(act_key::value, Value());
      made.set(act_key::candidates, std::move(candidates));
    }
  }
  if (is_open(fill, spans)) {
    const TokenRange words{fill.begin, fill.end};
    if (is_spelt(utterance.tokens, words))
      made.set(act_key::value, spelt_word(utterance.tokens, words));
    made.set(act_key::confidence,
             certainty_of_words(utterance,
                                {words, {act.begin, act.end}, act.elliptical}));
  }
  made.set(act_key::text, text);
  return made;
}

// The token behind what the act says before this value.
std::uint32_t end_before(const BuiltAct& act, const Fill& fill) {
  std::uint32_t end = 0;
  for (const auto& other : act.fills)
    if (other.end <= fill.begin)
      end = std::max(end, other.end);
  return end;
}

} // namespace

Map act_value(const BuiltAct& act, const Utterance& utterance,
              const Spans& spans, const Schema& schema) {
  Map slots;
  for (const auto& fill : act.fills) {
    const bool many =
        act.topic != no_topic && schema.at(act.topic).takes_many(fill.slot);
    auto value = fill_value(fill, utterance, spans, schema, act);
    if (!many) {
      slots.set(fill.slot, std::move(value));
      continue;
    }
    auto amount =
        amount_before(utterance.tokens, fill.begin, end_before(act, fill));
    // "I don't want a coffee any more": none at all.
    if (act.act == "deny" && amount.by_article && !slots.find(fill.slot))
      amount = {};
    add_item(slots, fill.slot, *value.if_map(), amount);
  }
  const auto topic =
      act.topic == no_topic ? Value() : Value(schema.at(act.topic).name);
  return Map{{act_key::topic, topic},
             {act_key::act, act.act},
             {act_key::confidence, in_thousandths(std::min(1.0, act.score))},
             {act_key::slots, std::move(slots)},
             {act_key::text,
              words_of(utterance.text, utterance.tokens, act.begin, act.end)},
             {act_key::elliptical, act.elliptical}};
}

} // namespace parlour::adapters::nlu
