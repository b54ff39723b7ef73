#include "adapters/nlu/values/heard_names.hpp"

#include <algorithm>
#include <functional>
#include <string>
#include <string_view>
#include <utility>

#include "adapters/nlu/text/name_sounds.hpp"
#include "adapters/nlu/text/phones.hpp"
#include "adapters/nlu/text/words.hpp"

namespace parlour::adapters::nlu {

namespace {

constexpr std::size_t most_words = 8;
// Shorter names sound like too much else.
constexpr std::size_t least_sounds = 5;
// How alike they must be as a whole, where the words are others of names but
// not as many, and each word: Peter Low is no Peter Ho.
constexpr double least_alike = 0.75;
constexpr double least_in_other_words = 0.85;
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
// Of sounds that are divided as the words of a name, for one utterance.
constexpr std::size_t most_divisions = 1'000;

struct Heard {
  ValueMatch match;
  double evidence = 0;
};

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
  // "I am …" and "my name is …" lead in who speaks. They are no part of it.
  bool is_own_name(std::uint32_t begin) const {
    const auto leads_in = [&](std::uint32_t at) {
      const auto& list = tokens_.list;
      return list[at].word == "am" ||
             (list[at].word == "is" && at > 0 && list[at - 1].word == "name");
    };
    return leads_in(begin) || (begin > 0 && leads_in(begin - 1));
  }

  // Words that may be a name.
  struct Run {
    std::uint32_t begin;
    std::vector<std::string> words;
    NameSounds sounds;
    // They hardly are parts of other words.
    bool are_words_of_names;
  };

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
      if (unknown * 2 >= names && !is_beside_names(begin, at + 1))
        compare(
            {begin, words, sounds_of_name(words), are_words_of_names(words)});
    }
  }

  bool is_of_grammars_only(std::uint32_t at) const {
    return plain_[at] && !index_.has_word(tokens_.list[at].word);
  }

  bool are_words_of_names(const std::vector<std::string>& words) const {
    return std::ranges::all_of(words, [&](const std::string& word) {
      return joins_names(word) || index_.has_word(word);
    });
  }

  // "To see him, Boon Keng": words that grammars use, and after a pause words
  // of names.
  bool is_beside_names(std::uint32_t begin, std::uint32_t end) const {
    const auto& list = tokens_.list;
    auto pause = begin;
    while (pause < end && is_of_grammars_only(pause))
      ++pause;
    return begin < pause && pause < end && list[pause].before != Break::none &&
           std::all_of(
               list.begin() + pause, list.begin() + end,
               [&](const Token& token) { return index_.has_word(token.word); });
  }

  using Found = std::vector<std::pair<double, std::uint32_t>>;

  void compare(const Run& run) {
    const auto& heard = run.sounds;
    if (heard.phones.size() < least_sounds)
      return;
    --runs_left_;
    Found found;
    for (std::uint32_t name = 0; name < names_.size(); ++name)
      if (may_be_alike(heard, names_[name]))
        if (const auto alike =
                sounds_alike(heard.phones, names_[name].phones, least_alike);
            alike >= least_alike && may_be(run, name, alike))
          found.emplace_back(-alike, name);
    if (found.empty())
      found = beside_the_first(run);
    if (found.empty())
      return;
    std::ranges::sort(found);
    const auto end = run.begin + static_cast<std::uint32_t>(run.words.size());
    ValueMatch match{set_, run.begin, end, {}, -found[0].first, true, false};
    for (const auto& [unlike, name] : found)
      if (unlike <= found[0].first + as_good &&
          match.values.size() < most_names)
        match.values.push_back(name);
    const auto evidence =
        (match.confidence - of_no_worth) * double(heard.phones.size());
    heard_.push_back({std::move(match), evidence});
  }

  // Names that begin with the first of these words, of which the others are no
  // words of names, nor of grammars.
  Found beside_the_first(const Run& run) const {
    const auto& words = run.words;
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
        found.emplace_back(
            -sounds_alike(run.sounds.phones, names_[name].phones), name);
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

  // `alike`: how much the whole run sounds like the name.
  bool may_be(const Run& run, std::uint32_t name, double alike) {
    auto words = run.words;
    const auto name_words = words_of_name(name);
    auto others = name_words;
    std::erase_if(words, joins_names);
    std::erase_if(others, joins_names);
    if (words.size() == others.size()) {
      if (is_enough(unlike_pairs(words, others), others, alike))
        return true;
      if (run.are_words_of_names)
        return false;
    } else if (is_part_of(words, others) ||
               (run.are_words_of_names && alike < least_in_other_words)) {
      return false;
    }
    if (divisions_left_ == 0)
      return false;
    --divisions_left_;
    return is_enough(
        words_unlike(run.sounds.phones, name_words, least_of_a_word), others,
        alike);
  }

  static bool is_enough(std::size_t unlike,
                        const std::vector<std::string>& name, double alike) {
    return unlike == 0 ||
           (name.size() >= 3 && (unlike == 1 || alike >= least_of_many_words));
  }

  static std::size_t unlike_pairs(const std::vector<std::string>& words,
                                  const std::vector<std::string>& others) {
    std::size_t unlike = 0;
    for (std::size_t at = 0; at < words.size(); ++at)
      if (sounds_alike(phones_of(words[at]), phones_of(others[at])) <
          least_of_a_word)
        ++unlike;
    return unlike;
  }

  // A part of the name as it is written is found by ValueIndex::find.
  static bool is_part_of(const std::vector<std::string>& words,
                         const std::vector<std::string>& name) {
    return std::ranges::all_of(words, [&](const std::string& word) {
      return std::ranges::find(name, word) != name.end();
    });
  }

  const ValueIndex& index_;
  const SetId set_;
  const std::vector<NameSounds>& names_;
  const Tokens& tokens_;
  const std::vector<bool>& plain_;
  std::size_t runs_left_;
  std::size_t divisions_left_ = most_divisions;
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

void add_names_of_the_same_sound(const ValueIndex& index, ValueMatch& match) {
  if (match.values.size() != 1 || !match.whole || !index.has_people(match.set))
    return;
  const auto said = match.values[0];
  const auto& names = index.sounds(match.set);
  for (std::uint32_t name = 0; name < names.size(); ++name)
    if (name != said && names[name].phones == names[said].phones)
      match.values.push_back(name);
}

} // namespace parlour::adapters::nlu
