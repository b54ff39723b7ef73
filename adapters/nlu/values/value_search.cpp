#include "adapters/nlu/values/value_search.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "adapters/nlu/forms/number_words.hpp"
#include "adapters/nlu/text/has.hpp"
#include "adapters/nlu/text/words.hpp"

namespace parlour::adapters::nlu {

namespace {

// How far a match may reach, in tokens.
constexpr std::size_t widest_window = 16;
constexpr std::size_t max_candidates = 50;
// A match with a lower confidence is dropped. Values whose quality is this
// close to the best one's are candidates, too.
constexpr double min_confidence = 0.6;
constexpr double equally_good = 0.03;
// The same for people, and what a word beside one costs that is left over.
constexpr double min_of_people = 0.7;
constexpr double stranger_cost = 0.5;
// A single word of a longer name must be more like it: "market" is no author.
constexpr double single_word = 0.95;
constexpr double single_name = 0.815; // "asthma" is no Jane Austen
// So must a single word of any other longer value: "giving" is no living room.
constexpr double single_part = 0.87;
// A word that names nothing by itself: "the Times" may be "The Time Machine".
constexpr double vague_part = 0.62;
// "mug" for "cup".
constexpr float synonym_similarity = 0.93F;
// How many words may be skipped within a value: "son of", "er".
constexpr std::size_t most_skipped = 3;

int count(std::uint16_t mask) {
  return std::popcount(mask);
}

bool is_letter(std::string_view word) {
  return word.size() == 1 && !has_digit(word);
}

// A word with another meaning that may be a name as well, since it is said like
// one: "joanna so", "kelvin go".
bool may_be_name(std::string_view word) {
  return word == "so" || word == "go" || !is_function_word(word);
}

} // namespace

ValueSearch::ValueSearch(const ValueIndex& index, const Tokens& tokens,
                         const std::vector<bool>& plain)
    : index_(index), tokens_(tokens), plain_(plain), fits_(tokens.list.size()),
      ends_(tokens.list.size() + 1) {}

std::vector<ValueMatch> ValueSearch::run() {
  collect_fits();
  for (std::size_t begin = 0; begin < tokens_.list.size(); ++begin)
    search_from(begin);
  return std::move(matches_);
}

// Finds the values that each token fits, sorted by value, so that extend() can
// walk through partial matches and fits together.
void ValueSearch::collect_fits() {
  for (std::size_t position = 0; position < fits_.size(); ++position)
    add_fits(position);
  for (std::size_t position = 0; position < fits_.size(); ++position)
    add_joined(position);
  for (std::size_t position = 1; position < fits_.size(); ++position)
    add_said_alike(position);
  for (auto& fits : fits_)
    std::ranges::stable_sort(fits, {}, &Fit::value);
}

// A plain word, or one with digits, is only looked up exactly.
void ValueSearch::add_fits(std::size_t position) {
  const auto& word = tokens_.list[position].word;
  const bool misspelt = !plain_[position] && !has_digit(word);
  look_up(position, word, misspelt, 1);
  if (const auto other = index_.synonyms_.find(word);
      other != index_.synonyms_.end())
    for (const auto& posting : other->second)
      fits_[position].push_back(
          {posting.value, posting.mask, 1, synonym_similarity, false});
  if (is_letter(word) &&
      (position == 0 || !is_letter(tokens_.list[position - 1].word)))
    add_spelt(position);
}

// Two tokens may be a word that was split ("coffee shop" for "coffeeshop"), or
// two that were split elsewhere. "With an H" does not mean somebody called Anh.
void ValueSearch::add_joined(std::size_t position) {
  const auto next = position + 1;
  const auto& word = tokens_.list[position].word;
  if (next >= fits_.size() || tokens_.list[next].before != Break::none ||
      (is_function_word(word) && is_letter(tokens_.list[next].word)))
    return;
  const bool joined = !plain_[position] && !has_digit(word) && !plain_[next] &&
                      (fits_[position].empty() || fits_[next].empty());
  look_up(position, word + tokens_.list[next].word, joined, 2);
}

// "T A N": letters one by one, from three on.
void ValueSearch::add_spelt(std::size_t position) {
  std::string word;
  auto at = position;
  while (at < fits_.size() && is_letter(tokens_.list[at].word))
    word += tokens_.list[at++].word;
  const auto length = at - position;
  if (length < 2 || length > widest_window)
    return;
  look_up(position, word, length > 3, static_cast<std::uint8_t>(length), true);
}

// Behind a word of a name, a word with a meaning of its own may be a name, too.
void ValueSearch::add_said_alike(std::size_t position) {
  const auto& word = tokens_.list[position].word;
  auto before = position - 1;
  while (before > 0 && is_hesitation(tokens_.list[before].word))
    --before;
  if (!plain_[position] || plain_[before] || fits_[before].empty() ||
      !fits_[position].empty() || !may_be_name(word) || has_digit(word) ||
      is_title(word) || is_light(word))
    return;
  add_hits(position, index_.words_, index_.words_.index.find_said_alike(word),
           1, false);
}

void ValueSearch::look_up(std::size_t position, std::string_view word,
                          bool misspelt, std::uint8_t length, bool spelt) {
  using enum Spelling;
  const auto& words = index_.words_;
  const auto& joined = index_.joined_;
  add_hits(position, words, words.index.find(word, misspelt ? loose : exact),
           length, spelt);
  add_hits(position, joined, joined.index.find(word, misspelt ? nearly : exact),
           length, spelt);
}

void ValueSearch::add_hits(std::size_t position, const ValueIndex::Lists& lists,
                           const std::vector<WordIndex::Hit>& hits,
                           std::uint8_t length, bool spelt) {
  for (const auto& hit : hits)
    for (const auto& posting : lists.postings[hit.word]) {
      const auto set = index_.values_[posting.value].set;
      if (!hit.only_said || index_.sets_[set].of_people)
        fits_[position].push_back({posting.value, posting.mask, length,
                                   static_cast<float>(hit.similarity), spelt});
    }
}

// All matches that begin at this token. A match does not begin with a light
// word unless the value needs it.
void ValueSearch::search_from(std::size_t begin) {
  if (fits_[begin].empty())
    return;
  const auto last = std::min(begin + widest_window, tokens_.list.size());
  const bool light = is_light(tokens_.list[begin].word);
  for (const auto& fit : fits_[begin]) {
    const auto heavy = index_.values_[fit.value].heavy;
    // "do" is no part of "Bhavani d/o Letchumanan".
    if ((fit.mask & heavy) == 0 && (light || heavy != 0))
      continue;
    ends_[begin + fit.length].push_back({fit.value, fit.mask, fit.length,
                                         fit.similarity * float(fit.length),
                                         fit.similarity, !plain_[begin]});
  }
  // ends_[end] is complete here: partial matches only grow to the right.
  // extend() is called again to skip light words, titles and hesitations inside
  // of the value.
  for (auto end = begin + 1; end <= last; ++end) {
    auto partials = std::exchange(ends_[end], {});
    if (partials.empty())
      continue;
    tidy(partials);
    emit(begin, end, partials);
    extend(partials, begin, end);
    for (auto skip = end;
         skip < end + most_skipped && skip + 1 < last && may_skip(skip); ++skip)
      extend(partials, begin, skip + 1);
  }
  // Clears what reached beyond the window.
  for (auto end = last; end < ends_.size(); ++end)
    ends_[end].clear();
}

bool ValueSearch::may_skip(std::size_t position) const {
  const auto& word = tokens_.list[position].word;
  return is_light(word) || is_title(word) || is_hesitation(word);
}

// Extends each partial match by the fits at `position` that belong to the same
// value.
void ValueSearch::extend(const Partials& partials, std::size_t begin,
                         std::size_t position) {
  if (position >= tokens_.list.size() ||
      tokens_.list[position].before == Break::sentence ||
      position - begin >= widest_window)
    return;
  const auto& fits = fits_[position];
  auto fit = fits.begin();
  for (const auto& partial : partials) {
    while (fit != fits.end() && fit->value < partial.value)
      ++fit;
    for (auto same = fit; same != fits.end() && same->value == partial.value;
         ++same)
      extend_by(partial, *same, position);
  }
}

// By words not yet found, or by one that is said again letter by letter.
void ValueSearch::extend_by(const Partial& partial, const Fit& fit,
                            std::size_t position) {
  const auto both = fit.mask & partial.mask;
  if (both != 0 && !(fit.spelt && both == fit.mask))
    return;
  auto longer = partial;
  longer.own_word = longer.own_word || !plain_[position];
  if (both == 0) {
    const int words = fit.spelt ? 1 : fit.length;
    longer.mask |= fit.mask;
    longer.count = static_cast<std::uint8_t>(longer.count + words);
    longer.similarity += fit.similarity * static_cast<float>(words);
    longer.fidelity *= fit.similarity;
  }
  ends_[position + fit.length].push_back(longer);
}

// Sorts by value, as they often are already, and keeps the best partial match
// of each: the one with most words, then the most similar.
void ValueSearch::tidy(Partials& partials) const {
  const auto before = [](const Partial& left, const Partial& right) {
    if (left.value != right.value)
      return left.value < right.value;
    return count(left.mask) != count(right.mask)
               ? count(left.mask) > count(right.mask)
               : left.similarity > right.similarity;
  };
  if (!std::ranges::is_sorted(partials, before))
    std::ranges::sort(partials, before);
  const auto same = [](const Partial& left, const Partial& right) {
    return left.value == right.value;
  };
  partials.erase(std::unique(partials.begin(), partials.end(), same),
                 partials.end());
}

// The partial matches are sorted by value, and values by set: each run of one
// set competes on its own.
void ValueSearch::emit(std::size_t begin, std::size_t end,
                       const Partials& partials) {
  for (std::size_t first = 0; first < partials.size();) {
    const auto set = index_.values_[partials[first].value].set;
    auto last = first;
    while (last < partials.size() &&
           index_.values_[partials[last].value].set == set)
      ++last;
    emit_set(begin, end, std::span(partials).subspan(first, last - first));
    first = last;
  }
}

// The share of the value's required words that was said.
double ValueSearch::recall(const Partial& partial) const {
  const auto& value = index_.values_[partial.value];
  const auto said = count(partial.mask & value.heavy);
  return double(said) / double(std::max(1, count(value.heavy)));
}

bool ValueSearch::of_people(const Partial& partial) const {
  return index_.sets_[index_.values_[partial.value].set].of_people;
}

// How similar the words are. Each word of a person's name counts, not their
// average.
double ValueSearch::likeness(const Partial& partial) const {
  return of_people(partial) ? double(partial.fidelity)
                            : double(partial.similarity) / partial.count;
}

// Compares values, with a bonus for one that was said completely.
double ValueSearch::quality(const Partial& partial) const {
  return likeness(partial) + (whole(partial) ? 0.2 : 0.0);
}

// Unknown words, and with people words of other names.
bool ValueSearch::is_stranger(std::size_t position, SetId set) const {
  const auto& word = tokens_.list[position].word;
  if (is_title(word) || is_letter(word) || is_light(word) || has_digit(word))
    return false;
  if (!plain_[position])
    return true;
  return index_.sets_[set].of_people && !is_light(word) &&
         std::ranges::any_of(fits_[position], [&](const Fit& fit) {
           return index_.values_[fit.value].set == set && count(fit.mask) == 1;
         });
}

// Counts words beside the window that may belong to a name which is not in the
// set: "Jeffery Smith" is not Jeffery Ho. At most two before and two behind.
// Connectors ("bin", "son of") and hesitations are passed over.
std::size_t ValueSearch::strangers(std::size_t begin, std::size_t end,
                                   SetId set) const {
  const auto& list = tokens_.list;
  const bool people = index_.sets_[set].of_people;
  const auto is_link = [&](std::size_t at) {
    const auto& word = list[at].word;
    return is_hesitation(word) ||
           (people && (is_connector(word) || word == "of" || is_title(word)));
  };
  std::size_t found = 0;
  for (auto at = begin; at > 0 && list[at].before == Break::none && found < 2;
       --at)
    if (is_stranger(at - 1, set))
      ++found;
    else if (!is_link(at - 1))
      break;
  // The words after "of" count too: "a glass of water" does not mean one of the
  // glasses.
  auto at = end;
  if (at + 1 < list.size() && list[at].word == "of")
    ++at;
  for (; at < list.size() && list[at].before == Break::none && found < 4; ++at)
    if (is_stranger(at, set))
      ++found;
    else if (!is_link(at))
      break;
  return found;
}

// A value that was said in part must be spelt better, and unknown words beside
// it count against it: "Changi" is not the money changer. Beside the name of a
// person, they mean another person.
double ValueSearch::confidence(const Partial& partial, std::size_t begin,
                               std::size_t end) const {
  const auto& value = index_.values_[partial.value];
  const auto others = double(strangers(begin, end, value.set));
  const auto alike = likeness(partial);
  const bool is_single = partial.count == 1 && !whole(partial);
  if (is_single && alike < (of_people(partial) ? single_name : single_part))
    return 0;
  if (of_people(partial))
    return alike * (0.9 + 0.1 * recall(partial)) *
           (is_single ? single_word : 1) * std::pow(stranger_cost, others);
  if (whole(partial))
    return alike;
  const auto said = count(partial.mask & value.heavy);
  if (said == 0 || (said == 1 && is_vague(tokens_.list[end - 1].word)))
    return said * vague_part;
  return alike * alike * (0.9 + 0.1 * recall(partial)) * partial.count /
         (partial.count + others);
}

// "to" is no "Journey to the Centre of the Earth", nor "three" the musketeers.
// In "and chips", "and" leads in, and is no part of "fish and chips".
bool ValueSearch::is_plain_part(const Partial& partial, std::size_t begin,
                                std::size_t end) const {
  if (whole(partial) || of_people(partial))
    return false;
  const bool begins_value = (partial.mask & 1U) != 0 && partial.fidelity >= 1;
  if (is_function_word(tokens_.list[begin].word) && !begins_value)
    return true;
  for (auto at = begin; at < end; ++at)
    if (const auto& word = tokens_.list[at].word;
        !is_function_word(word) && !is_light(word) && !is_number_word(word))
      return false;
  return true;
}

void ValueSearch::emit_set(std::size_t begin, std::size_t end,
                           std::span<const Partial> partials) {
  const auto* best = &partials[0];
  for (const auto& partial : partials)
    if (quality(partial) > quality(*best))
      best = &partial;
  if (is_plain_part(*best, begin, end))
    return;
  const auto sure = confidence(*best, begin, end);
  if (sure < (of_people(*best) ? min_of_people : min_confidence))
    return;
  ValueMatch match{index_.values_[best->value].set,
                   static_cast<std::uint32_t>(begin),
                   static_cast<std::uint32_t>(end),
                   {},
                   sure,
                   whole(*best),
                   false};
  match.stands_alone = match.whole || (best->own_word && recall(*best) >= 0.5);
  for (const auto& partial : partials)
    if (quality(partial) >= quality(*best) - equally_good &&
        match.values.size() < max_candidates)
      match.values.push_back(partial.value - index_.sets_[match.set].first);
  matches_.push_back(std::move(match));
}

} // namespace parlour::adapters::nlu
