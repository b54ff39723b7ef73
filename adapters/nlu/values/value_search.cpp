#include "adapters/nlu/values/value_search.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "adapters/nlu/text/words.hpp"

namespace parlour::adapters::nlu {

namespace {

// How far a match may reach, in tokens.
constexpr std::size_t widest_window = 10;
constexpr std::size_t max_candidates = 50;
// A match with a lower confidence is dropped. Values whose quality is this
// close to the best one's are candidates, too.
constexpr double min_confidence = 0.6;
constexpr double equally_good = 0.03;
// Two words written as one must be almost correct: "jeffery" is not
// "jefferyho".
constexpr double joined_similarity = 0.92;

int count(std::uint16_t mask) {
  return std::popcount(mask);
}

bool has_digit(std::string_view word) {
  return word.find_first_of("0123456789") != std::string_view::npos;
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
  for (std::size_t position = 0; position < fits_.size(); ++position) {
    add_fits(position);
    std::ranges::stable_sort(fits_[position], {}, &Fit::value);
  }
}

// A plain word, or one with digits, is only looked up exactly. Two tokens
// together may be one word of a value that was split ("coffee shop" for
// "coffeeshop").
void ValueSearch::add_fits(std::size_t position) {
  const auto& word = tokens_.list[position].word;
  const bool misspelt = !plain_[position] && !has_digit(word);
  for (const auto& hit : index_.words_.find(word, misspelt))
    add_hit(position, hit, 1);
  const auto next = position + 1;
  if (next >= fits_.size() || tokens_.list[next].before != Break::none)
    return;
  const bool joined = misspelt && !plain_[next] && fits_[position].empty();
  for (const auto& hit :
       index_.words_.find(word + tokens_.list[next].word, joined))
    add_hit(position, hit, 2);
}

void ValueSearch::add_hit(std::size_t position, const WordIndex::Hit& hit,
                          std::uint8_t length) {
  const auto similarity = static_cast<float>(hit.similarity);
  for (const auto& posting : index_.postings_[hit.word]) {
    if (count(posting.mask) > 1 && hit.similarity < joined_similarity)
      continue;
    fits_[position].push_back(
        {posting.value, posting.mask, length, similarity});
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
    if (light && (fit.mask & heavy) == 0)
      continue;
    ends_[begin + fit.length].push_back({fit.value, fit.mask, fit.length,
                                         fit.similarity * fit.length,
                                         !plain_[begin]});
  }
  // ends_[end] is complete here: partial matches only grow to the right.
  // extend() is called a second time to skip a light word or a title inside of
  // the value.
  for (auto end = begin + 1; end <= last; ++end) {
    auto partials = std::exchange(ends_[end], {});
    if (partials.empty())
      continue;
    tidy(partials);
    emit(begin, end, partials);
    extend(partials, begin, end, end);
    if (end + 1 < last && may_skip(end))
      extend(partials, begin, end + 1, end + 1);
  }
  // Clears what reached beyond the window.
  for (auto end = last; end < ends_.size() && end <= last + 2; ++end)
    ends_[end].clear();
}

bool ValueSearch::may_skip(std::size_t position) const {
  const auto& word = tokens_.list[position].word;
  return is_light(word) || is_title(word);
}

// Extends each partial match by the fits at `position` that belong to the same
// value and to words not yet found. `target` is the position behind which the
// result ends.
void ValueSearch::extend(const Partials& partials, std::size_t begin,
                         std::size_t position, std::size_t target) {
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
         ++same) {
      if ((same->mask & partial.mask) != 0)
        continue;
      auto longer = partial;
      longer.mask |= same->mask;
      longer.count = static_cast<std::uint8_t>(longer.count + same->length);
      longer.similarity += same->similarity * same->length;
      longer.own_word = longer.own_word || !plain_[position];
      ends_[target + same->length].push_back(longer);
    }
  }
}

// Sorts by value and keeps the best partial match of each: the one with most
// words, then the most similar.
void ValueSearch::tidy(Partials& partials) const {
  std::ranges::sort(partials, [](const Partial& left, const Partial& right) {
    if (left.value != right.value)
      return left.value < right.value;
    return count(left.mask) != count(right.mask)
               ? count(left.mask) > count(right.mask)
               : left.similarity > right.similarity;
  });
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

bool ValueSearch::whole(const Partial& partial) const {
  const auto heavy = index_.values_[partial.value].heavy;
  return (partial.mask & heavy) == heavy;
}

// Compares values: the average similarity of the words, with a bonus for a
// value that was said completely.
double ValueSearch::quality(const Partial& partial) const {
  return double(partial.similarity) / partial.count +
         (whole(partial) ? 0.2 : 0.0);
}

// Counts unknown words beside the window that may belong to a name which is not
// in the set: "Jeffery Smith" is not Jeffery Ho. At most two before and two
// behind.
std::size_t ValueSearch::strangers(std::size_t begin, std::size_t end) const {
  std::size_t found = 0;
  const auto is_stranger = [&](std::size_t position) {
    const auto& word = tokens_.list[position].word;
    return !plain_[position] && !is_light(word) && !is_title(word) &&
           !has_digit(word);
  };
  for (auto at = begin; at > 0 && tokens_.list[at].before == Break::none &&
                        is_stranger(at - 1) && found < 2;
       --at)
    ++found;
  // The words after "of" count too: "a glass of water" does not mean one of the
  // glasses.
  auto at = end;
  if (at + 1 < tokens_.list.size() && tokens_.list[at].word == "of")
    ++at;
  for (; at < tokens_.list.size() && tokens_.list[at].before == Break::none &&
         is_stranger(at) && found < 4;
       ++at)
    ++found;
  return found;
}

void ValueSearch::emit_set(std::size_t begin, std::size_t end,
                           std::span<const Partial> partials) {
  const auto* best = &partials[0];
  for (const auto& partial : partials)
    if (quality(partial) > quality(*best))
      best = &partial;
  const auto used = double(best->count);
  auto confidence = double(best->similarity) / used;
  // A value that was said in part must be spelt better, and unknown words
  // beside it count against it: "Changi" is not the money changer.
  if (!whole(*best))
    confidence *= confidence * (0.9 + 0.1 * recall(*best)) * used /
                  (used + double(strangers(begin, end)));
  if (confidence < min_confidence)
    return;
  ValueMatch match{index_.values_[best->value].set,
                   static_cast<std::uint32_t>(begin),
                   static_cast<std::uint32_t>(end),
                   {},
                   confidence,
                   whole(*best),
                   false};
  match.stands_alone = match.whole || (best->own_word && recall(*best) >= 0.5);
  for (const auto& partial : partials)
    if (quality(partial) >= quality(*best) - equally_good &&
        match.values.size() < max_candidates)
      match.values.push_back(partial.value - index_.sets_[match.set]);
  matches_.push_back(std::move(match));
}

} // namespace parlour::adapters::nlu
