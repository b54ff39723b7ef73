// Known values are found once, in the constructor: normal forms first, since
// their tokens are no part of names. Open words are found on demand, because
// there are many of them.
#include "adapters/nlu/parse/spans.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>
#include <string_view>
#include <tuple>
#include <utility>

#include "adapters/nlu/forms/first_words.hpp"
#include "adapters/nlu/forms/number_words.hpp"
#include "adapters/nlu/parse/pronoun_one.hpp"
#include "adapters/nlu/text/words.hpp"
#include "adapters/nlu/values/heard_names.hpp"
#include "runtime/text/shifted_time.hpp"

namespace parlour::adapters::nlu {

namespace {

// The gain of a number that is no value of what was asked. It is small, since
// any other reading is more likely.
constexpr float wrong_number_gain = 0.15F;
// The gain of a verb at the beginning of open words: less than a name's.
constexpr float deed_gain = 0.2F;

// What a word of the rest of a clause gains: with the words before it, more
// than a rule that takes the same words for its own, but less than "at noon"
// behind them.
constexpr float rest_gain = 0.7F;
constexpr std::size_t most_rest = 30;

// Such a name is not asked back about though it was heard otherwise.
constexpr float well_understood_name = 0.7F;

// How many titles and determiners may stand before open words.
constexpr std::size_t most_leading = 3;

// Open words may begin with a verb that has little meaning by itself: "remind
// me to take out the bin".
bool is_deed(const Tokens& tokens, std::size_t position) {
  static constexpr std::array<std::string_view, 12> verbs{
      "take", "make", "find", "get",  "go",   "come",
      "give", "say",  "tell", "look", "show", "help"};
  return position > 0 && tokens.list[position - 1].word == "to" &&
         std::ranges::find(verbs, tokens.list[position].word) != verbs.end();
}

// Of these tokens, with nothing before the value itself.
Span span_of(EntityId entity, std::size_t begin, std::size_t end) {
  Span span;
  span.entity = entity;
  span.begin = span.core = static_cast<std::uint32_t>(begin);
  span.end = static_cast<std::uint32_t>(end);
  return span;
}

// Whether all these words are a value of some set, or the same name and well
// understood.
bool names_as_well(const Span& span, const ValueMatch& heard, EntityId entity) {
  return is_set(span.entity) && span.begin <= heard.begin &&
         heard.end <= span.end &&
         (span.is_certain() ||
          (span.entity == entity && span.values == heard.values &&
           span.confidence >= well_understood_name));
}

bool is_number_like(const Tokens& tokens, std::size_t position) {
  const auto& word = tokens.list[position].word;
  return word.find_first_of("0123456789@") != std::string::npos ||
         number_at(tokens, position).has_value();
}

} // namespace

Spans::Spans(const Schema& schema, const Utterance& utterance,
             const std::vector<EntityId>& entities, Now now, bool heard,
             bool chooses)
    : schema_(schema), utterance_(utterance), plain_(utterance.plain),
      leads_(utterance.size()), stands_(utterance.size()),
      first_at_(utterance.size() + 1), entities_(utterance.size()),
      last_opened_(utterance.size()), opened_(1) {
  for (std::size_t at = 0; at < utterance.size(); ++at) {
    const auto& word = utterance.tokens.list[at].word;
    leads_[at] = is_title(word) || is_determiner(word);
    stands_[at] =
        !utterance.filler[at] && !utterance.function[at] && !is_comment(word);
  }
  add_forms(entities, now);
  add_values(entities, heard && !chooses);
  if (heard)
    add_heard_names(entities);
  order();
}

void Spans::order() {
  indices_.resize(spans_.size());
  std::iota(indices_.begin(), indices_.end(), 0U);
  std::ranges::sort(indices_, {}, [&](std::uint32_t index) {
    return std::tuple(spans_[index].begin, spans_[index].entity, index);
  });
  for (const auto& span : spans_) {
    ++first_at_[span.begin + 1];
    entities_[span.begin] |= entity_bit(span.entity);
  }
  std::partial_sum(first_at_.begin(), first_at_.end(), first_at_.begin());
}

void Spans::add_forms(const std::vector<EntityId>& entities, Now now) {
  std::vector<Forms> begin;
  begin.reserve(utterance_.size());
  for (const auto& token : utterance_.tokens.list)
    begin.push_back(forms_from(token.word));
  for (const auto entity : entities) {
    if (!is_form(entity))
      continue;
    const auto form = static_cast<Form>(entity);
    for (std::uint32_t at = 0; at < utterance_.size(); ++at) {
      if ((begin[at] & forms_bit(form)) == 0)
        continue;
      auto found = form_at(form, utterance_.tokens, at, now);
      if (!found || found->length == 0 ||
          (found->length == 1 && is_pronoun_one(utterance_, at)))
        continue;
      if (form == Form::time)
        lean_on_time_before(found->value);
      auto span = span_of(entity, at, at + found->length);
      span.value = std::move(found->value);
      span.weak = found->weak;
      mark_plain(span);
      add(std::move(span));
    }
  }
}

// "At quarter past ten. No, half past."
void Spans::lean_on_time_before(Value& time) const {
  for (auto span = spans_.rbegin(); span != spans_.rend(); ++span)
    if (span->entity == static_cast<EntityId>(Form::time))
      if (auto moved = shifted_time(span->value, time); !moved.is_unknown()) {
        time = std::move(moved);
        return;
      }
}

// The tokens of a time or date are part of no name: "Dr. Ho tomorrow".
void Spans::mark_plain(const Span& span) {
  if (!span.weak)
    for (auto at = span.begin; at < span.end; ++at)
      plain_[at] = true;
}

void Spans::add_values(const std::vector<EntityId>& entities,
                       bool with_same_sound) {
  if (entities.empty() || !is_set(entities.back()))
    return;
  for (auto& match : schema_.values().find(utterance_.tokens, plain_)) {
    const auto entity = first_set_entity + match.set;
    if (!std::ranges::binary_search(entities, entity))
      continue;
    if (with_same_sound)
      add_names_of_the_same_sound(schema_.values(), match);
    auto span = span_of(entity, match.begin, match.end);
    span.values = std::move(match.values);
    span.confidence = static_cast<float>(match.confidence);
    span.weak = !match.stands_alone;
    add(std::move(span));
  }
}

// Where no name is said as it is. They count only where a name is expected, as
// much as they sound like it, and are asked back about.
void Spans::add_heard_names(const std::vector<EntityId>& entities) {
  const auto known = std::ssize(spans_);
  for (const auto entity : entities)
    if (is_set(entity))
      for (auto& match :
           heard_names(schema_.values(), entity - first_set_entity,
                       utterance_.tokens, plain_))
        if (std::none_of(spans_.begin(), spans_.begin() + known,
                         [&](const Span& span) {
                           return names_as_well(span, match, entity);
                         }))
          add_heard_name(entity, std::move(match));
}

void Spans::add_heard_name(EntityId entity, ValueMatch&& match) {
  auto span = span_of(entity, match.begin, match.end);
  span.weak = span.only_heard = true;
  span.values = std::move(match.values);
  span.confidence = static_cast<float>(match.confidence);
  const auto first = spans_.size();
  add(std::move(span));
  for (auto added = first; added < spans_.size(); ++added)
    spans_[added].confidence = heard_confidence;
}

// Adds the span, and a copy of it for each title and determiner before it.
void Spans::add(Span span) {
  const auto tokens = static_cast<float>(span.end - span.begin);
  const auto weight =
      static_cast<float>(utterance_.weight_of(span.begin, span.end));
  span.covered = weight * span.confidence;
  // Each token of a value is worth a word, even a function word. A weak value
  // is worth no more than its words: "now".
  span.gain = (span.weak ? weight : tokens) * span.confidence;
  while (true) {
    spans_.push_back(span);
    if (span.begin == 0 ||
        utterance_.tokens.list[span.begin].before != Break::none ||
        !leads_[span.begin - 1])
      return;
    --span.begin;
    span.gain += 0.5F;
    span.covered += utterance_.weight[span.begin];
  }
}

Spans::Indices Spans::all_at(std::size_t position) const {
  return Indices(indices_).subspan(
      first_at_[position], first_at_[position + 1] - first_at_[position]);
}

Spans::Indices Spans::at(EntityId entity, std::size_t position) const {
  if ((entities_[position] & entity_bit(entity)) == 0)
    return {};
  const auto entity_of = [&](std::uint32_t index) {
    return spans_[index].entity;
  };
  const auto here = all_at(position);
  return Indices(std::ranges::lower_bound(here, entity, {}, entity_of),
                 std::ranges::upper_bound(here, entity, {}, entity_of));
}

// Whether a value of this entity begins in [first, last).
bool Spans::value_near(EntityId entity, std::size_t first,
                       std::size_t last) const {
  for (auto begin = first; begin < last && begin < utterance_.size(); ++begin)
    if (!at(entity, begin).empty())
      return true;
  return false;
}

bool Spans::is_known(std::size_t position) const {
  return std::ranges::any_of(all_at(position), [&](std::uint32_t index) {
    return is_set(spans_[index].entity) && !spans_[index].weak;
  });
}

// Whether the word before may belong to the same name.
bool Spans::inside_name(std::size_t position) const {
  return position > 0 &&
         utterance_.tokens.list[position].before == Break::none &&
         !plain_[position - 1];
}

// Titles and determiners may precede the value.
std::size_t Spans::behind_leading(std::size_t position) const {
  const auto last = std::min(position + most_leading, utterance_.size());
  while (position < last && leads_[position])
    ++position;
  return position;
}

bool Spans::may_open(std::size_t position) const {
  const auto first = behind_leading(position);
  return first < utterance_.size() &&
         (stands_[first] || is_deed(utterance_.tokens, first));
}

// What a token adds to the gain of open words. Unknown words are likelier to be
// a value than words that grammars use.
float Spans::open_gain(std::size_t position) const {
  if (!stands_[position])
    return -0.2F;
  return plain_[position] ? 0.2F : 0.8F;
}

// Returns one span for the longest run of numbers that have no other certain
// meaning.
void Spans::open_number(EntityId entity, std::size_t position,
                        std::size_t most) {
  const auto& tokens = utterance_.tokens;
  const auto last = std::min(position + most, utterance_.size());
  auto end = position;
  while (end < last && is_number_like(tokens, end) &&
         (end == position || tokens.list[end].before == Break::none) &&
         std::ranges::none_of(all_at(end), [&](std::uint32_t index) {
           return spans_[index].entity == entity || !spans_[index].weak;
         }))
    ++end;
  if (end == position)
    return;
  auto span = span_of(entity, position, end);
  span.unmatched = true;
  span.gain = wrong_number_gain * static_cast<float>(end - position);
  span.covered = static_cast<float>(utterance_.weight_of(position, end)) * 0.7F;
  spans_.push_back(std::move(span));
}

Spans::Indices Spans::open(EntityId entity, std::size_t position,
                           std::size_t most) {
  // The matcher asks the same for every partial match at this position.
  for (auto at = last_opened_[position]; at != 0; at = opened_[at].before)
    if (const auto& opened = opened_[at];
        opened.entity == entity && opened.most == most)
      return Indices(indices_).subspan(opened.begin, opened.count);
  const auto known = indices_.size();
  auto next = spans_.size();
  make_open(entity, position, most);
  for (; next < spans_.size(); ++next)
    indices_.push_back(static_cast<std::uint32_t>(next));
  opened_.push_back({entity, most, known, indices_.size() - known,
                     std::exchange(last_opened_[position], opened_.size())});
  return Indices(indices_).subspan(known);
}

void Spans::make_open(EntityId entity, std::size_t position, std::size_t most) {
  if (entity == rest_entity)
    rest_of_clause(position);
  else if (is_form(entity))
    open_number(entity, position, most);
  else
    open_words(entity, position, most);
}

void Spans::open_words(EntityId entity, std::size_t position,
                       std::size_t most) {
  const bool of_set = is_set(entity);
  const auto size = utterance_.size();
  const auto first = behind_leading(position);
  float gain = 0;
  const bool taken = of_set && (is_known(position) || inside_name(position));
  // Adds a span for each end at which open words may stop. The gain grows with
  // each word. Open words of a set stop before a known value of it.
  for (auto at = first; !taken && at < size && at < first + most; ++at) {
    if (at > position && utterance_.tokens.list[at].before != Break::none)
      break;
    const bool deed =
        entity == words_entity && at == first && is_deed(utterance_.tokens, at);
    gain += (deed ? deed_gain : open_gain(at)) * (of_set ? 0.7F : 1.0F);
    if ((at == first && !deed && !stands_[at]) ||
        (of_set && value_near(entity, at, at + 2)))
      break;
    if (!stands_[at])
      continue;
    auto span = span_of(entity, position, at + 1);
    span.core = static_cast<std::uint32_t>(first);
    span.unmatched = of_set;
    span.gain = gain;
    span.covered = static_cast<float>(utterance_.weight_of(position, at + 1) *
                                      (of_set ? 0.7 : 0.9));
    spans_.push_back(std::move(span));
  }
}

std::uint32_t Spans::with_values(std::uint32_t index,
                                 std::vector<std::uint32_t> values) {
  auto span = spans_[index];
  span.values = std::move(values);
  span.confidence = std::max(span.confidence, certain_value);
  spans_.push_back(std::move(span));
  return static_cast<std::uint32_t>(spans_.size() - 1);
}

Spans::Indices Spans::rest(std::size_t position) {
  return open(rest_entity, position, most_rest);
}

void Spans::rest_of_clause(std::size_t position) {
  const auto size = std::min(utterance_.size(), position + most_rest);
  for (auto at = position; at < size; ++at) {
    if (at > position && utterance_.tokens.list[at].before != Break::none)
      break;
    auto span = span_of(rest_entity, position, at + 1);
    span.gain = rest_gain * static_cast<float>(at + 1 - position);
    span.covered = static_cast<float>(utterance_.weight_of(position, at + 1));
    spans_.push_back(std::move(span));
  }
}

} // namespace parlour::adapters::nlu
