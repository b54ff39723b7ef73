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

constexpr std::size_t max_candidates = 50;
// A match with a lower confidence is dropped.
constexpr double min_confidence = 0.6;
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
// How many words may be skipped within a value: "son of", "er".
constexpr std::size_t most_skipped = 3;

int count(std::uint16_t mask) {
  return std::popcount(mask);
}

} // namespace

ValueSearch::ValueSearch(const ValueIndex& index, const Tokens& tokens,
                         const std::vector<bool>& plain)
    : index_(index), tokens_(tokens), plain_(plain),
      fits_(ValueFits(index, tokens, plain).run()),
      ends_(tokens.list.size() + 1) {}

std::vector<ValueMatch> ValueSearch::run() {
  for (std::size_t begin = 0; begin < tokens_.list.size(); ++begin)
    search_from(begin);
  return std::move(matches_);
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
  return likeness(partial) + (whole(partial) ? said_wholly : 0.0);
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

// Here, so that the index knows nothing of its search.
std::vector<ValueMatch> ValueIndex::find(const Tokens& tokens,
                                         const std::vector<bool>& plain) const {
  return ValueSearch(*this, tokens, plain).run();
}

} // namespace parlour::adapters::nlu
