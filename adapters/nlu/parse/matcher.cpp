#include "adapters/nlu/parse/matcher.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "adapters/nlu/text/negation.hpp"

namespace parlour::adapters::nlu {

namespace {

// How many partial matches are kept at a token, and for how many memory is
// reserved.
constexpr std::size_t max_items = 400;
constexpr std::size_t usual_items = 16;
// How many matches may end at a token, and for how many memory is reserved.
constexpr std::size_t max_matches = 32;
constexpr std::size_t usual_matches = 8;
// How many words in a row may be skipped; fillers do not count.
constexpr std::uint8_t max_skipped = 3;
// How many words `@words` takes, and how many if the last question wants any
// words.
constexpr std::size_t max_open_words = 5;
constexpr std::size_t max_asked_words = 10;
// A filler that a rule asks for is worth at least this.
constexpr float filler_gain = 0.1F;

// The cost of crossing punctuation. A rule hardly ever goes on in the next
// sentence.
float break_cost(Break found) {
  switch (found) {
  case Break::none:
    return 0;
  case Break::comma:
    return 0.1F;
  case Break::sentence:
    return 1;
  }
  return 0;
}

std::uint8_t one_more(std::uint8_t count) {
  return count < 250 ? count + 1 : count;
}

} // namespace

Matcher::Matcher(const Automaton& automaton, const Utterance& utterance,
                 Spans& spans, EntityId asked, std::string grammar)
    : automaton_(automaton), utterance_(utterance), spans_(spans),
      asked_(asked), grammar_(std::move(grammar)), items_(utterance.size() + 1),
      found_(utterance.size() + 1) {
  here_.reserve(utterance.size());
  ahead_.reserve(utterance.size() + 1);
  skips_.reserve(utterance.size());
  for (std::size_t at = 0; at < utterance.size(); ++at) {
    here_.push_back(takes_at(at));
    skips_.push_back(skip_of(at));
  }
  for (std::size_t at = 0; at <= utterance.size(); ++at)
    ahead_.push_back(takes_from(at));
  traces_.reserve(usual_items * utterance.size());
  // Entry 0 means the end of a list.
  traces_.emplace_back();
}

std::vector<Match> Matcher::run() {
  if (automaton_.states.empty())
    return {};
  // All partial matches that reach token `at` are known here, since every step
  // leads to a later token. A new match may begin at each token.
  for (std::uint32_t at = 0; at < utterance_.size(); ++at) {
    auto items = std::exchange(items_[at], {});
    limit(items);
    for (const auto& item : items)
      step(at, item);
    items.clear();
    spare_ = std::move(items);
    Item start;
    start.begin = start.last = at;
    take_word(at, start);
    take_entities(at, start);
  }
  std::vector<Match> matches;
  for (auto& ending : found_) {
    // Of equally good ones that which fills more, then the first in the
    // grammar.
    std::ranges::stable_sort(ending, std::greater(), [](const Match& match) {
      return std::tuple(match.score, match.filled);
    });
    if (ending.size() > max_matches)
      ending.resize(max_matches);
    matches.insert(matches.end(), ending.begin(), ending.end());
  }
  return matches;
}

// Keeps the best partial match for each state, beginning and strength; of
// equally good ones the first. They stay in the order of the grammar.
void Matcher::carry(const Item& item, std::size_t position) {
  if (!may_go_on(item, position))
    return;
  auto& items = items_[position];
  if (items.capacity() == 0) {
    items.swap(spare_);
    items.reserve(usual_items);
  }
  for (auto& other : items) {
    if (other.state != item.state || other.begin != item.begin ||
        other.weak != item.weak)
      continue;
    if (std::tie(item.score, item.filled) > std::tie(other.score, other.filled))
      other = item;
    return;
  }
  if (items.size() == 2 * max_items)
    limit(items);
  items.push_back(item);
}

// Keeps the best max_items.
void Matcher::limit(std::vector<Item>& items) {
  if (items.size() <= max_items)
    return;
  std::ranges::stable_sort(items, std::greater(), &Item::score);
  items.resize(max_items);
}

void Matcher::step(std::size_t position, const Item& item) {
  take_word(position, item);
  take_entities(position, item);
  skip(position, item);
}

// Skips a token that the rule does not have: a filler is nearly free, a word
// with a meaning of its own costs more than a function word. A negation is
// never skipped, since it turns the meaning round. Neither is any "not" by what
// is said about the conversation: "I can not see" is no "I see".
void Matcher::skip(std::size_t position, const Item& item) {
  const auto& skip = skips_[position];
  if (utterance_.negates[position] || !may_go_on(item, position + 1) ||
      (skip.counts && item.skipped >= max_skipped))
    return;
  auto next = item;
  if (skip.counts)
    ++next.skipped;
  next.score -= skip.cost;
  next.score -= break_cost(utterance_.tokens.list[position].before);
  next.denied = item.denied || skip.denies;
  carry(next, position + 1);
}

Matcher::Skip Matcher::skip_of(std::size_t position) const {
  const bool filler = utterance_.filler[position];
  return {filler                          ? 0.02F
          : utterance_.function[position] ? 0.25F
                                          : 0.6F,
          !filler, is_not(utterance_.tokens.list[position].word)};
}

// Known values, the value that a question asks for, and behind a word of the
// rule open words, which take no normal form.
Matcher::Takes Matcher::takes_at(std::size_t position) const {
  Takes takes;
  if (const auto word = utterance_.words[position]; word != unknown_word)
    takes.words |= word_bit(word);
  if (const auto* synonyms = utterance_.synonyms[position])
    for (const auto word : *synonyms)
      takes.words |= word_bit(word);
  takes.first = spans_.entities_at(position);
  if (asked_ != asked_entity)
    takes.first |= entity_bit(asked_entity);
  takes.behind_word =
      takes.first |
      (spans_.may_open(position) ? ~form_bits : entity_bit(rest_entity));
  return takes;
}

Matcher::Takes Matcher::takes_from(std::size_t position) const {
  Takes takes;
  for (int skipped = 0; position < utterance_.size(); ++position) {
    const auto& here = here_[position];
    takes.words |= here.words;
    takes.first |= here.first;
    takes.behind_word |= here.behind_word;
    if (utterance_.negates[position] ||
        (!utterance_.filler[position] && ++skipped > max_skipped))
      break;
  }
  return takes;
}

// Whether a word or value that the state takes may still come. Most partial
// matches end here, which saves their being carried on.
bool Matcher::may_go_on(const Item& item, std::size_t position) const {
  const auto& state = automaton_.states[item.state];
  const auto& ahead = ahead_[position];
  return (state.word_bits & ahead.words) != 0 ||
         (state.entity_bits & ahead.entities(item)) != 0;
}

// A synonym is worth a little less than the word that the rule has.
constexpr float synonym_cost = 0.1F;

void Matcher::take_word(std::size_t position, const Item& item) {
  const auto& state = automaton_.states[item.state];
  if ((state.word_bits & here_[position].words) == 0)
    return;
  if (const auto word = utterance_.words[position]; word != unknown_word)
    follow_word(position, item, word, 0);
  if (const auto* synonyms = utterance_.synonyms[position])
    for (const auto word : *synonyms)
      follow_word(position, item, word, synonym_cost);
}

// Follows the arcs that take this word.
void Matcher::follow_word(std::size_t position, const Item& item,
                          WordNumber word, float cost) {
  const auto here = static_cast<std::uint32_t>(position);
  const auto& state = automaton_.states[item.state];
  if ((state.word_bits & word_bit(word)) == 0)
    return;
  for (const auto& arc : arcs_of(state.words, word)) {
    ++work_;
    auto next = item;
    follow(next, arc.actions, here);
    next.state = arc.target;
    next.last = here + 1;
    next.skipped = 0;
    next.weak = false;
    next.words = one_more(item.words);
    const auto weight = utterance_.weight[position];
    next.score += std::max(weight, filler_gain) + arc.weight - cost;
    next.covered += weight;
    // Punctuation before the first word of a match costs nothing.
    if (position > item.begin)
      next.score -= break_cost(utterance_.tokens.list[position].before);
    reach(next, position + 1);
  }
}

void Matcher::take_entities(std::size_t position, const Item& item) {
  const auto& state = automaton_.states[item.state];
  const auto takes = here_[position].entities(item);
  if ((state.entity_bits & takes) == 0)
    return;
  for (const auto& arc : state.entities)
    if ((entity_bit(arc.symbol) & takes) != 0)
      take_entity(position, item, arc);
}

// Takes the known values that begin here. If there is none and a value is
// expected, takes open words. A normal form takes them only if the last
// question wants it.
void Matcher::take_entity(std::size_t position, const Item& item,
                          const Arc& arc) {
  ++work_;
  const bool asked = arc.symbol == asked_entity;
  const auto entity = asked ? asked_ : arc.symbol;
  if (entity == asked_entity)
    return;
  // After a word of the grammar, or where a question asks for it, a value is
  // expected.
  const bool expected = asked || item.words > 0;
  if (entity == rest_entity) {
    if (item.words > 0 && item.skipped == 0)
      for (const auto index : spans_.rest(position))
        take_span(item, arc, index, true);
    return;
  }
  if (entity != words_entity) {
    const auto known = spans_.at(entity, position);
    for (const auto index : known)
      take_span(item, arc, index, expected);
    const bool is_named = std::ranges::any_of(
        known, [&](std::uint32_t index) { return !spans_[index].only_heard; });
    if (is_named || (is_form(entity) && !asked))
      return;
  }
  // Open words are all that stands there: "I am Anouk, Windmolen" is no
  // Windmolen.
  const bool passed_over = entity == words_entity && item.skipped > 0;
  if (expected && !passed_over)
    for (const auto index : spans_.open(
             entity, position, asked ? max_asked_words : max_open_words))
      take_span(item, arc, index, expected);
}

void Matcher::take_span(const Item& item, const Arc& arc, std::uint32_t index,
                        bool expected) {
  const auto& span = spans_[index];
  auto next = item;
  follow(next, arc.actions, span.begin);
  next.trace = push({next.trace, index, span.begin, Trace::Kind::span});
  next.state = arc.target;
  next.last = span.end;
  next.skipped = 0;
  next.weak = item.weak || (span.weak && !expected);
  next.score += span.gain + arc.weight;
  next.covered += span.covered;
  if (span.begin > item.begin)
    next.score -= break_cost(utterance_.tokens.list[span.begin].before);
  reach(next, span.end);
}

void Matcher::reach(const Item& item, std::size_t position) {
  for (const auto& accepted : automaton_.states[item.state].accepts)
    accept(item, accepted);
  carry(item, position);
}

// Records a match. Of several matches of the same rule, tokens and strength,
// the best is kept, of equally good ones the one that fills more. Only a rule
// of nothing but a value may consist of a weak value.
void Matcher::accept(const Item& item, const Accept& accepted) {
  const auto& rule = automaton_.rules[accepted.rule];
  if ((item.weak && !rule.bare) || (item.denied && rule.generic) ||
      !is_tried(rule))
    return;
  auto whole = item;
  whole.score += accepted.weight + rule.bias;
  auto& ending = found_[item.last];
  if (ending.empty())
    ending.reserve(usual_matches);
  const auto same = std::ranges::find_if(ending, [&](const Match& other) {
    return other.rule == accepted.rule && other.begin == item.begin &&
           other.weak == item.weak;
  });
  if (same != ending.end() && same->score > whole.score)
    return;
  follow(whole, accepted.actions, item.last);
  if (same != ending.end() && std::tie(same->score, same->filled) >=
                                  std::tie(whole.score, whole.filled))
    return;
  // A value without a sentence around it counts as understood a little less.
  const Match match{accepted.rule,
                    item.begin,
                    item.last,
                    whole.score,
                    item.covered * (rule.bare ? 0.9F : 1),
                    whole.trace,
                    item.weak,
                    whole.filled};
  if (same != ending.end())
    *same = match;
  else
    ending.push_back(match);
}

// Examples and bare values belong to no grammar, so they are not tried if the
// context names one.
bool Matcher::is_tried(const RuleInfo& rule) const {
  return grammar_.empty() || rule.generic || rule.grammar == grammar_;
}

// Opening and closing are recorded at different positions: a tag opens at the
// next token, and closes behind the last token that was taken.
void Matcher::follow(Item& item, std::uint32_t actions, std::uint32_t open_at) {
  for (const auto& action : automaton_.actions[actions]) {
    if (action.opens)
      item.trace = push({item.trace, action.tag, open_at, Trace::Kind::open});
    else
      item.trace =
          push({item.trace, action.tag, item.last, Trace::Kind::close});
    if (!action.opens && has_extent(automaton_.tags[action.tag].kind))
      item.filled = one_more(item.filled);
  }
}

std::uint32_t Matcher::push(Trace trace) {
  traces_.push_back(trace);
  return static_cast<std::uint32_t>(traces_.size() - 1);
}

} // namespace parlour::adapters::nlu
