#include "adapters/nlu/values/value_fits.hpp"

#include <algorithm>

#include "adapters/nlu/text/has.hpp"
#include "adapters/nlu/text/words.hpp"

namespace parlour::adapters::nlu {

namespace {

// "mug" for "cup".
constexpr float synonym_similarity = 0.93F;
// From here below the best, a value is no candidate beside it: qualities are
// sums of decimals.
constexpr double hopeless = equally_good + 1e-6;
// Of so few, none is left out: it would not be worth it.
constexpr std::size_t few_fits = 256;

// A word with another meaning that may be a name as well, since it is said like
// one: "joanna so", "kelvin go".
bool may_be_name(std::string_view word) {
  return word == "so" || word == "go" || !is_function_word(word);
}

} // namespace

ValueFits::ValueFits(const ValueIndex& index, const Tokens& tokens,
                     const std::vector<bool>& plain)
    : index_(index), tokens_(tokens), plain_(plain),
      found_(tokens.list.size()) {}

std::vector<std::vector<ValueFits::Fit>> ValueFits::run() {
  find();
  count();
  std::vector<std::vector<Fit>> fits(found_.size());
  for (std::size_t position = 0; position < fits.size(); ++position)
    fits[position] = fits_at(position);
  return fits;
}

// -- words --------------------------------------------------------------------

void ValueFits::find() {
  for (std::size_t position = 0; position < found_.size(); ++position)
    find_at(position);
  for (std::size_t position = 0; position < found_.size(); ++position)
    find_joined(position);
  for (std::size_t position = 1; position < found_.size(); ++position)
    find_said_alike(position);
}

// A plain word, or one with digits, is only looked up exactly.
void ValueFits::find_at(std::size_t position) {
  const auto& word = tokens_.list[position].word;
  const bool misspelt = !plain_[position] && !has_digit(word);
  look_up(position, word, misspelt, 1);
  if (const auto other = index_.synonyms_.find(word);
      other != index_.synonyms_.end())
    found_[position].push_back(
        {other->second, 1, synonym_similarity, false, false});
  if (is_letter(word) &&
      (position == 0 || !is_letter(tokens_.list[position - 1].word)))
    find_spelt(position);
}

// Two tokens may be a word that was split ("coffee shop" for "coffeeshop"), or
// two that were split elsewhere. "With an H" does not mean somebody called Anh.
void ValueFits::find_joined(std::size_t position) {
  const auto next = position + 1;
  const auto& word = tokens_.list[position].word;
  if (next >= found_.size() || tokens_.list[next].before != Break::none ||
      (is_function_word(word) && is_letter(tokens_.list[next].word)))
    return;
  const bool joined = !plain_[position] && !has_digit(word) && !plain_[next] &&
                      (found_[position].empty() || found_[next].empty());
  look_up(position, word + tokens_.list[next].word, joined, 2);
}

// "T A N": letters one by one, from three on.
void ValueFits::find_spelt(std::size_t position) {
  std::string word;
  auto at = position;
  while (at < found_.size() && is_letter(tokens_.list[at].word))
    word += tokens_.list[at++].word;
  const auto length = at - position;
  if (length < 2 || length > widest_window)
    return;
  look_up(position, word, length > 3, static_cast<std::uint8_t>(length), true);
}

// Behind a word of a name, a word with a meaning of its own may be a name, too.
void ValueFits::find_said_alike(std::size_t position) {
  const auto& word = tokens_.list[position].word;
  auto before = position - 1;
  while (before > 0 && is_hesitation(tokens_.list[before].word))
    --before;
  if (!plain_[position] || plain_[before] || found_[before].empty() ||
      !found_[position].empty() || !may_be_name(word) || has_digit(word) ||
      is_title(word) || is_light(word))
    return;
  add(position, index_.words_, index_.words_.index.find_said_alike(word), 1,
      false);
}

void ValueFits::look_up(std::size_t position, std::string_view word,
                        bool misspelt, std::uint8_t length, bool spelt) {
  using enum Spelling;
  const auto& words = index_.words_;
  const auto& joined = index_.joined_;
  add(position, words, words.index.find(word, misspelt ? loose : exact), length,
      spelt);
  add(position, joined, joined.index.find(word, misspelt ? nearly : exact),
      length, spelt);
}

void ValueFits::add(std::size_t position, const ValueIndex::Lists& lists,
                    const std::vector<WordIndex::Hit>& hits,
                    std::uint8_t length, bool spelt) {
  for (const auto& hit : hits) {
    const Found found{lists.postings[hit.word], length,
                      static_cast<float>(hit.similarity), spelt, hit.only_said};
    if (std::ranges::any_of(found.postings, [&](const auto& posting) {
          return takes(found, posting);
        }))
      found_[position].push_back(found);
  }
}

// -- values -------------------------------------------------------------------

bool ValueFits::takes(const Found& found, const Posting& posting) const {
  return !found.of_people ||
         index_.sets_[index_.values_[posting.value].set].of_people;
}

void ValueFits::count() {
  std::size_t all = 0;
  for (const auto& at_token : found_)
    for (const auto& found : at_token)
      all += found.postings.size();
  if (all <= few_fits)
    return;
  times_.resize(index_.values_.size());
  for (const auto& at_token : found_)
    for (const auto& found : at_token)
      for (const auto& posting : found.postings)
        if (takes(found, posting)) {
          auto& times = times_[posting.value];
          times = times == 0 ? 1 : 2;
        }
}

// As if nothing else of the value was said; see ValueSearch::quality().
double ValueFits::quality(const Found& found, const Posting& posting) const {
  const bool whole = (index_.values_[posting.value].heavy & ~posting.mask) == 0;
  return double(found.similarity) + (whole ? said_wholly : 0.0);
}

ValueFits::Best& ValueFits::best_of(Bests& bests, const Found& found,
                                    const Posting& posting) const {
  auto& [all, last] = bests;
  const Best way{index_.values_[posting.value].set, found.length,
                 (posting.mask & (posting.mask - 1)) == 0, 0};
  const auto is_same = [&](const Best& best) {
    return best.set == way.set && best.length == way.length &&
           best.one_word == way.one_word;
  };
  if (last >= all.size() || !is_same(all[last])) {
    const auto same = std::ranges::find_if(all, is_same);
    last = static_cast<std::size_t>(same - all.begin());
    if (same == all.end())
      all.push_back(way);
  }
  return all[last];
}

ValueFits::Bests ValueFits::bests(const std::vector<Found>& all) const {
  Bests bests;
  for (const auto& found : all)
    for (const auto& posting : found.postings)
      if (takes(found, posting)) {
        auto& best = best_of(bests, found, posting);
        best.quality = std::max(best.quality, quality(found, posting));
      }
  return bests;
}

// A value that fits at this token only is at most a candidate beside the best
// of its set, and not even that by a light word ("bin").
std::vector<ValueFits::Fit> ValueFits::fits_at(std::size_t position) const {
  const bool many = !times_.empty();
  const bool light = is_light(tokens_.list[position].word);
  auto best = many ? bests(found_[position]) : Bests();
  const auto is_hopeless = [&](const Found& found, const Posting& posting) {
    const auto heavy = index_.values_[posting.value].heavy;
    return times_[posting.value] == 1 &&
           ((light && (posting.mask & heavy) == 0) ||
            quality(found, posting) <
                best_of(best, found, posting).quality - hopeless);
  };
  std::vector<Fit> fits;
  for (const auto& found : found_[position])
    for (const auto& posting : found.postings)
      if (takes(found, posting) && !(many && is_hopeless(found, posting)))
        fits.push_back({posting.value, posting.mask, found.length,
                        found.similarity, found.spelt});
  if (!std::ranges::is_sorted(fits, {}, &Fit::value))
    std::ranges::stable_sort(fits, {}, &Fit::value);
  return fits;
}

} // namespace parlour::adapters::nlu
