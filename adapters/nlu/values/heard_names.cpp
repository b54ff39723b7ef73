#include "adapters/nlu/values/heard_names.hpp"

#include <algorithm>
#include <functional>
#include <string>
#include <string_view>
#include <utility>

#include "adapters/nlu/text/phones.hpp"
#include "adapters/nlu/text/words.hpp"

namespace parlour::adapters::nlu {

namespace {

constexpr std::size_t most_words = 8;
// Shorter names sound like too much else.
constexpr std::size_t least_sounds = 5;
// How alike they must be as a whole, where the words are others, and each word
// of as many: Peter Low is no Peter Ho.
constexpr double least_alike = 0.75;
constexpr double least_in_other_words = 0.8;
constexpr double least_of_a_word = 0.7;
// So much alike, and three words may be divided otherwise: "Fujun Kai Ad".
constexpr double least_of_many_words = 0.85;
// Which others are as good.
constexpr double as_good = 0.06;
constexpr std::size_t most_names = 3;
// How alike the rest of a name must be beside a word of it that is as written,
// where the rest is nobody's: "Lorraine Gove".
constexpr double least_of_the_rest = 0.6;
// A long name speaks for itself more than a short one, by each sound that is
// more alike than this.
constexpr double of_no_worth = 0.7;
// By how much of the longer one their lengths may differ.
constexpr double most_longer = 0.35;
// Of runs with names, for one utterance.
constexpr std::size_t most_comparisons = 2'000'000;

struct Heard {
  ValueMatch match;
  double evidence = 0;
};

// "bin", "son of": they are misheard most, and tell nobody apart.
bool joins_names(const std::string& word) {
  return is_light(word) || is_title(word);
}

bool may_be_alike(const NameSounds& one, const NameSounds& other) {
  const auto [shorter, longer] =
      std::minmax({one.phones.size(), other.phones.size()});
  return double(longer - shorter) <= most_longer * double(longer) &&
         sounds_alike_at_most(one.kinds, other.kinds, longer) >= least_alike;
}

class NameSearch {
public:
  NameSearch(const ValueIndex& index, SetId set, const Tokens& tokens,
             const std::vector<bool>& plain)
      : index_(index), set_(set), names_(index.sounds(set)), tokens_(tokens),
        plain_(plain),
        runs_left_(most_comparisons / std::max<std::size_t>(1, names_.size())) {
  }

  std::vector<ValueMatch> run() {
    for (std::uint32_t begin = 0; begin < tokens_.list.size(); ++begin)
      if (!is_own_name(begin))
        look_from(begin);
    std::ranges::stable_sort(heard_, std::greater(), &Heard::evidence);
    std::vector<ValueMatch> made;
    for (auto& heard : heard_)
      if (std::ranges::none_of(made, [&](const ValueMatch& better) {
            return better.begin < heard.match.end &&
                   heard.match.begin < better.end;
          }))
        made.push_back(std::move(heard.match));
    return made;
  }

private:
  // "I am …" and "my name is …" lead in who speaks.
  bool is_own_name(std::uint32_t begin) const {
    const auto before = [&](std::uint32_t by) -> std::string_view {
      return begin >= by ? tokens_.list[begin - by].word : std::string_view();
    };
    return before(1) == "am" || (before(1) == "is" && before(2) == "name");
  }

  void look_from(std::uint32_t begin) {
    const auto& list = tokens_.list;
    std::vector<std::string> words;
    std::size_t names = 0;
    std::size_t unknown = 0;
    for (auto at = begin; at < list.size() && at < begin + most_words; ++at) {
      const auto& word = list[at].word;
      if ((at > begin && list[at].before == Break::sentence) ||
          phones_of(word).empty() || runs_left_ == 0)
        return;
      words.push_back(word);
      if (joins_names(word))
        continue;
      ++names;
      unknown += plain_[at] ? 0U : 1U;
      if (unknown * 2 >= names)
        compare({set_, begin, at + 1, {}, 0, true, false}, words);
    }
  }

  using Found = std::vector<std::pair<double, std::uint32_t>>;

  void compare(ValueMatch match, const std::vector<std::string>& words) {
    const auto heard = sounds_of_name(words);
    if (heard.phones.size() < least_sounds)
      return;
    --runs_left_;
    Found found;
    for (std::uint32_t name = 0; name < names_.size(); ++name)
      if (may_be_alike(heard, names_[name]))
        if (const auto alike =
                sounds_alike(heard.phones, names_[name].phones, least_alike);
            alike >= least_alike && may_be(words, name, alike))
          found.emplace_back(-alike, name);
    if (found.empty())
      found = beside_the_first(words, heard, match);
    if (found.empty())
      return;
    std::ranges::sort(found);
    for (const auto& [unlike, name] : found)
      if (unlike <= found[0].first + as_good &&
          match.values.size() < most_names)
        match.values.push_back(name);
    match.confidence = -found[0].first;
    const auto evidence =
        (match.confidence - of_no_worth) * double(heard.phones.size());
    heard_.push_back({std::move(match), evidence});
  }

  // Names that begin with the first of these words, of which the others are no
  // words of names, nor of grammars.
  Found beside_the_first(const std::vector<std::string>& words,
                         const NameSounds& heard, const ValueMatch& run) const {
    Found found;
    if (words.size() < 2 || !index_.has_word(words[0]))
      return found;
    for (std::size_t at = 0; at < words.size(); ++at)
      if (plain_[run.begin + at] || joins_names(words[at]) ||
          (at > 0 && index_.has_word(words[at])))
        return found;
    const auto first = phones_of(words[0]);
    const auto rest = sounds_of_name({words.begin() + 1, words.end()}).phones;
    for (std::uint32_t name = 0; name < names_.size(); ++name)
      if (names_[name].phones.find(first) != std::string::npos &&
          is_rest_alike(words[0], rest, name))
        found.emplace_back(-sounds_alike(heard.phones, names_[name].phones),
                           name);
    return found;
  }

  bool is_rest_alike(const std::string& first, const std::string& rest,
                     std::uint32_t name) const {
    auto words = words_of_name(name);
    if (words.size() < 2 || words[0] != first)
      return false;
    words.erase(words.begin());
    return sounds_alike(rest, sounds_of_name(words).phones) >=
           least_of_the_rest;
  }

  // Without titles.
  std::vector<std::string> words_of_name(std::uint32_t name) const {
    std::vector<std::string> words;
    for (auto& token : tokenize(index_.value(set_, name)).list)
      if (!is_title(token.word))
        words.push_back(std::move(token.word));
    return words;
  }

  bool may_be(std::vector<std::string> words, std::uint32_t name,
              double alike) const {
    auto others = words_of_name(name);
    std::erase_if(words, joins_names);
    std::erase_if(others, joins_names);
    // A part of the name as it is written is found by ValueIndex::find.
    if (words.size() != others.size())
      return alike >= least_in_other_words &&
             !std::ranges::all_of(words, [&](const std::string& word) {
               return std::ranges::find(others, word) != others.end();
             });
    std::size_t unlike = 0;
    for (std::size_t at = 0; at < words.size(); ++at)
      if (sounds_alike(phones_of(words[at]), phones_of(others[at])) <
          least_of_a_word)
        ++unlike;
    return unlike == 0 ||
           (words.size() >= 3 && (unlike == 1 || alike >= least_of_many_words));
  }

  const ValueIndex& index_;
  const SetId set_;
  const std::vector<NameSounds>& names_;
  const Tokens& tokens_;
  const std::vector<bool>& plain_;
  std::size_t runs_left_;
  std::vector<Heard> heard_;
};

} // namespace

std::vector<ValueMatch> heard_names(const ValueIndex& index, SetId set,
                                    const Tokens& tokens,
                                    const std::vector<bool>& plain) {
  return index.has_people(set) && !index.has_things(set)
             ? NameSearch(index, set, tokens, plain).run()
             : std::vector<ValueMatch>();
}

} // namespace parlour::adapters::nlu
