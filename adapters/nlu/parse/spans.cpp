// Known values are found once, in the constructor: normal forms first, since
// their tokens are no part of names. Open words are found on demand, because
// there are many of them.
#include "adapters/nlu/parse/spans.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "adapters/nlu/forms/first_words.hpp"
#include "adapters/nlu/forms/number_words.hpp"
#include "adapters/nlu/text/words.hpp"

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

// Open words may begin with a verb that has little meaning by itself: "remind
// me to take out the bin".
bool is_deed(const Tokens& tokens, std::size_t position) {
  static constexpr std::array<std::string_view, 12> verbs{
      "take", "make", "find", "get",  "go",   "come",
      "give", "say",  "tell", "look", "show", "help"};
  return position > 0 && tokens.list[position - 1].word == "to" &&
         std::ranges::find(verbs, tokens.list[position].word) != verbs.end();
}

// "one of those", "this one", "I've got one": no number.
bool is_pronoun(const Tokens& tokens, std::size_t position) {
  static constexpr std::array<std::string_view, 9> before{
      "this", "that", "which", "another", "other", "got", "buy", "new", "any"};
  const auto& list = tokens.list;
  if (list[position].word != "one")
    return false;
  return (position + 1 < list.size() && list[position + 1].word == "of") ||
         (position > 0 &&
          std::ranges::find(before, list[position - 1].word) != before.end());
}

bool is_number_like(const Tokens& tokens, std::size_t position) {
  const auto& word = tokens.list[position].word;
  return word.find_first_of("0123456789@") != std::string::npos ||
         number_at(tokens, position).has_value();
}

} // namespace

Spans::Spans(const Schema& schema, const Utterance& utterance,
             const std::vector<EntityId>& entities, Now now)
    : schema_(schema), utterance_(utterance), plain_(utterance.plain),
      by_begin_(utterance.size()), opened_(utterance.size()) {
  add_forms(entities, now);
  add_values(entities);
  for (auto& indices : by_begin_)
    std::ranges::stable_sort(
        indices, {}, [&](std::uint32_t index) { return spans_[index].entity; });
}

void Spans::add_forms(const std::vector<EntityId>& entities, Now now) {
  std::vector<bool> may_begin(utterance_.size());
  for (std::uint32_t at = 0; at < utterance_.size(); ++at)
    may_begin[at] = may_begin_form(utterance_.tokens.list[at].word);
  for (const auto entity : entities) {
    if (!is_form(entity))
      continue;
    const bool begins_anywhere = static_cast<Form>(entity) == Form::email;
    for (std::uint32_t at = 0; at < utterance_.size(); ++at) {
      if (!may_begin[at] && !begins_anywhere)
        continue;
      auto found =
          form_at(static_cast<Form>(entity), utterance_.tokens, at, now);
      if (!found || found->length == 0 ||
          (found->length == 1 && is_pronoun(utterance_.tokens, at)))
        continue;
      Span span{entity, at,    at, at, std::move(found->value), {}, 1,
                false,  false, 0,  0};
      span.end += static_cast<std::uint32_t>(found->length);
      span.weak = found->weak;
      mark_plain(span);
      add(std::move(span));
    }
  }
}

// The tokens of a time or date are part of no name: "Dr. Ho tomorrow".
void Spans::mark_plain(const Span& span) {
  if (!span.weak)
    for (auto at = span.begin; at < span.end; ++at)
      plain_[at] = true;
}

void Spans::add_values(const std::vector<EntityId>& entities) {
  if (entities.empty() || !is_set(entities.back()))
    return;
  for (auto& match : schema_.values().find(utterance_.tokens, plain_)) {
    const auto entity = first_set_entity + match.set;
    if (!std::ranges::binary_search(entities, entity))
      continue;
    Span span{entity, match.begin, match.end, match.begin, {}, {},
              1,      false,       false,     0,           0};
    span.values = std::move(match.values);
    span.confidence = static_cast<float>(match.confidence);
    span.weak = !match.stands_alone;
    add(std::move(span));
  }
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
    by_begin_[span.begin].push_back(static_cast<std::uint32_t>(spans_.size()));
    spans_.push_back(span);
    if (span.begin == 0 ||
        utterance_.tokens.list[span.begin].before != Break::none)
      return;
    const auto& word = utterance_.tokens.list[span.begin - 1].word;
    if (!is_title(word) && !is_determiner(word))
      return;
    --span.begin;
    span.gain += 0.5F;
    span.covered += utterance_.weight[span.begin];
  }
}

Spans::Indices Spans::at(EntityId entity, std::size_t position) const {
  const auto& indices = by_begin_[position];
  const auto of = [&](std::uint32_t index) { return spans_[index].entity; };
  return {std::ranges::lower_bound(indices, entity, {}, of),
          std::ranges::upper_bound(indices, entity, {}, of)};
}

// Whether a value of this entity begins in [first, last).
bool Spans::value_near(EntityId entity, std::size_t first,
                       std::size_t last) const {
  for (auto begin = first; begin < last && begin < by_begin_.size(); ++begin)
    if (!at(entity, begin).empty())
      return true;
  return false;
}

bool Spans::is_known(std::size_t position) const {
  return std::ranges::any_of(by_begin_[position], [&](std::uint32_t index) {
    return is_set(spans_[index].entity) && !spans_[index].weak;
  });
}

// Whether the word before may belong to the same name.
bool Spans::inside_name(std::size_t position) const {
  return position > 0 &&
         utterance_.tokens.list[position].before == Break::none &&
         !plain_[position - 1];
}

// Whether open words may begin or end with this token.
bool Spans::can_stand(std::size_t position) const {
  return !utterance_.filler[position] && !utterance_.function[position] &&
         !is_comment(utterance_.tokens.list[position].word);
}

// What a token adds to the gain of open words. Unknown words are likelier to be
// a value than words that grammars use.
float Spans::open_gain(std::size_t position) const {
  if (!can_stand(position))
    return -0.2F;
  return plain_[position] ? 0.2F : 0.8F;
}

// Returns one span for the longest run of numbers that have no other certain
// meaning.
std::vector<std::uint32_t>
Spans::open_number(EntityId entity, std::size_t position, std::size_t most) {
  const auto& tokens = utterance_.tokens;
  const auto last = std::min(position + most, utterance_.size());
  auto end = position;
  while (end < last && is_number_like(tokens, end) &&
         (end == position || tokens.list[end].before == Break::none) &&
         std::ranges::none_of(by_begin_[end], [&](std::uint32_t index) {
           return spans_[index].entity == entity || !spans_[index].weak;
         }))
    ++end;
  if (end == position)
    return {};
  const auto begin = static_cast<std::uint32_t>(position);
  Span span{entity, begin, static_cast<std::uint32_t>(end),
            begin,  {},    {},
            1,      false, true,
            0,      0};
  span.gain = wrong_number_gain * static_cast<float>(end - position);
  span.covered = static_cast<float>(utterance_.weight_of(position, end)) * 0.7F;
  spans_.push_back(std::move(span));
  return {static_cast<std::uint32_t>(spans_.size() - 1)};
}

Spans::Indices Spans::open(EntityId entity, std::size_t position,
                           std::size_t most) {
  // The matcher asks the same for every partial match at this position.
  for (const auto& opened : opened_[position])
    if (opened.entity == entity && opened.most == most)
      return opened.spans;
  opened_[position].push_back(
      {entity, most, make_open(entity, position, most)});
  return opened_[position].back().spans;
}

std::vector<std::uint32_t>
Spans::make_open(EntityId entity, std::size_t position, std::size_t most) {
  if (entity == rest_entity)
    return rest_of_clause(position);
  return is_form(entity) ? open_number(entity, position, most)
                         : open_words(entity, position, most);
}

std::vector<std::uint32_t>
Spans::open_words(EntityId entity, std::size_t position, std::size_t most) {
  std::vector<std::uint32_t> made;
  const bool of_set = is_set(entity);
  const auto size = utterance_.size();
  // Titles and determiners may precede the value.
  auto first = position;
  while (first < size && first < position + 3 &&
         (is_title(utterance_.tokens.list[first].word) ||
          is_determiner(utterance_.tokens.list[first].word)))
    ++first;
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
    if ((at == first && !deed && !can_stand(at)) ||
        (of_set && value_near(entity, at, at + 2)))
      break;
    if (!can_stand(at))
      continue;
    const auto weight = utterance_.weight_of(position, at + 1);
    made.push_back(static_cast<std::uint32_t>(spans_.size()));
    spans_.push_back({entity,
                      static_cast<std::uint32_t>(position),
                      static_cast<std::uint32_t>(at + 1),
                      static_cast<std::uint32_t>(first),
                      {},
                      {},
                      1,
                      false,
                      of_set,
                      gain,
                      static_cast<float>(weight * (of_set ? 0.7 : 0.9))});
  }
  return made;
}

Spans::Indices Spans::rest(std::size_t position) {
  return open(rest_entity, position, most_rest);
}

std::vector<std::uint32_t> Spans::rest_of_clause(std::size_t position) {
  std::vector<std::uint32_t> made;
  const auto size = std::min(utterance_.size(), position + most_rest);
  for (auto at = position; at < size; ++at) {
    if (at > position && utterance_.tokens.list[at].before != Break::none)
      break;
    const auto begin = static_cast<std::uint32_t>(position);
    Span span{rest_entity, begin, static_cast<std::uint32_t>(at + 1),
              begin,       {},    {},
              1,           false, false,
              0,           0};
    span.gain = rest_gain * static_cast<float>(at + 1 - position);
    span.covered = static_cast<float>(utterance_.weight_of(position, at + 1));
    made.push_back(static_cast<std::uint32_t>(spans_.size()));
    spans_.push_back(std::move(span));
  }
  return made;
}

} // namespace parlour::adapters::nlu
