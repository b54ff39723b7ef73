#include "adapters/nlu/values/heard_names.hpp"

#include <algorithm>
#include <functional>
#include <string>
#include <utility>

#include "adapters/nlu/text/phones.hpp"
#include "adapters/nlu/text/words.hpp"

namespace parlour::adapters::nlu {

namespace {

constexpr std::size_t most_words = 8;
// Shorter names sound like too much else.
constexpr std::size_t least_sounds = 5;
// How alike they must be, and which others are as good.
constexpr double least_alike = 0.75;
constexpr double as_good = 0.06;
// A long name speaks for itself more than a short one, by each sound that is
// more alike than this.
constexpr double of_no_worth = 0.7;
constexpr std::size_t most_names = 3;
// By how much of the longer one their lengths may differ.
constexpr double most_longer = 0.35;

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
  NameSearch(const ValueIndex& index, const Tokens& tokens)
      : index_(index), tokens_(tokens) {}

  std::vector<ValueMatch> run(SetId set) {
    for (std::uint32_t begin = 0; begin < tokens_.list.size(); ++begin)
      look_from(begin, set);
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
  void look_from(std::uint32_t begin, SetId set) {
    const auto& list = tokens_.list;
    std::vector<std::string> words;
    bool has_name = false;
    for (auto at = begin; at < list.size() && at < begin + most_words; ++at) {
      if (at > begin && list[at].before == Break::sentence)
        return;
      words.push_back(list[at].word);
      has_name = has_name || !is_function_word(list[at].word);
      if (has_name)
        compare({set, begin, at + 1, {}, 0, true, false}, words);
    }
  }

  void compare(ValueMatch match, const std::vector<std::string>& words) {
    const auto heard = sounds_of_name(words);
    if (heard.phones.size() < least_sounds)
      return;
    std::vector<std::pair<double, std::uint32_t>> found;
    const auto& names = index_.sounds(match.set);
    for (std::uint32_t name = 0; name < names.size(); ++name)
      if (may_be_alike(heard, names[name]))
        if (const auto alike =
                sounds_alike(heard.phones, names[name].phones, least_alike);
            alike >= least_alike)
          found.emplace_back(-alike, name);
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

  const ValueIndex& index_;
  const Tokens& tokens_;
  std::vector<Heard> heard_;
};

} // namespace

std::vector<ValueMatch> heard_names(const ValueIndex& index,
                                    const Tokens& tokens) {
  std::vector<ValueMatch> made;
  for (SetId set = 0; set < index.sets(); ++set)
    if (index.has_people(set) && !index.has_things(set))
      for (auto& match : NameSearch(index, tokens).run(set))
        made.push_back(std::move(match));
  return made;
}

std::vector<std::uint32_t> homophones(const ValueIndex& index, SetId set,
                                      std::uint32_t name) {
  const auto& names = index.sounds(set);
  std::vector<std::uint32_t> made{name};
  for (std::uint32_t other = 0; other < names.size(); ++other)
    if (other != name && names[other].phones == names[name].phones &&
        names[name].phones.size() >= least_sounds)
      made.push_back(other);
  return made;
}

} // namespace parlour::adapters::nlu
