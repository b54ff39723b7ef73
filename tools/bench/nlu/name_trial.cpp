#include "tools/bench/nlu/name_trial.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <sstream>
#include <string_view>
#include <utility>

#include "runtime/base/random.hpp"

namespace parlour::tools {

namespace {

using Words = std::vector<std::string>;

// Names that are in none of the databases.
constexpr std::array<std::string_view, 20> given_names{
    "Bartholomew", "Ingrid",    "Thorvald",  "Giuseppe", "Esperanza",
    "Wolfgang",    "Katarzyna", "Oluwaseun", "Francois", "Yevgenia",
    "Mikkel",      "Guadalupe", "Zbigniew",  "Lysander", "Philippa",
    "Ezequiel",    "Ottoline",  "Kwabena",   "Leopold",  "Genevieve"};
constexpr std::array<std::string_view, 16> family_names{
    "Higginbotham", "Lindqvist", "Kowalczyk",  "Okonkwo",
    "Featherstone", "Papadakis", "Villanueva", "Montgomery",
    "Vandenberg",   "Abernathy", "Castellano", "Hutchinson",
    "Grunewald",    "Petrovsky", "Fitzgerald", "Delacroix"};

// The words of a name, without the connectors that may be left out.
Words words_of(const std::string& name) {
  std::istringstream in(name);
  Words words;
  for (std::string word; in >> word;)
    if (word.find('/') == std::string::npos && word != "bin" &&
        word != "binte" && word != "bte")
      words.push_back(std::move(word));
  return words;
}

std::string joined(const Words& words) {
  std::string text;
  for (const auto& word : words)
    text += (text.empty() ? "" : " ") + word;
  return text;
}

bool has_all(const Words& name, const Words& words) {
  return std::ranges::all_of(words, [&](const auto& word) {
    return std::ranges::find(name, word) != name.end();
  });
}

class Trials {
public:
  explicit Trials(const std::vector<std::string>& names) {
    for (const auto& name : names)
      names_.push_back(words_of(name));
  }

  // Three variants of each name: rotated, with a word missing, and misspelt.
  std::vector<NameTrial> run(const std::vector<std::string>& names) {
    for (std::size_t at = 0; at < names.size(); ++at) {
      const auto& words = names_[at];
      auto turned = words;
      std::rotate(turned.begin(), turned.begin() + 1, turned.end());
      add(turned, names[at]);
      auto part = words;
      part.erase(part.begin() + pick(part.size()));
      add(part, names[at]);
      if (means_one(words))
        made_.push_back({joined(misspelt(words)), names[at]});
    }
    return std::move(made_);
  }

private:
  std::ptrdiff_t pick(std::size_t size) {
    return static_cast<std::ptrdiff_t>(random_.next() % size);
  }

  // Whether exactly one name has all these words.
  bool means_one(const Words& words) const {
    return !words.empty() &&
           std::ranges::count_if(names_, [&](const auto& one) {
             return has_all(one, words);
           }) == 1;
  }

  void add(const Words& words, const std::string& name) {
    if (means_one(words))
      made_.push_back({joined(words), name});
  }

  // Spoils one letter of a word with at least four letters.
  Words misspelt(Words words) {
    Words::iterator longest = std::ranges::max_element(
        words, {}, [](const auto& word) { return word.size(); });
    auto& word = words[static_cast<std::size_t>(pick(words.size()))];
    spoil(word.size() < 4 ? *longest : word);
    return words;
  }

  // Drops, doubles, swaps or replaces a letter; never the first one, which
  // hardly anybody gets wrong.
  void spoil(std::string& word) {
    const auto at = static_cast<std::size_t>(1 + pick(word.size() - 2));
    switch (pick(4)) {
    case 0:
      word.erase(at, 1);
      return;
    case 1:
      word.insert(at, 1, word[at]);
      return;
    case 2:
      std::swap(word[at], word[at + 1]);
      return;
    default:
      word[at] = other_letter(word[at]);
    }
  }

  // Letters that are easily confused.
  static char other_letter(char letter) {
    constexpr std::string_view from = "aeioucksztdpbfvmnlr";
    constexpr std::string_view to = "eaeuokczstdbpvfnmrl";
    const auto at = from.find(letter);
    return at == std::string_view::npos ? 'e' : to[at];
  }

  std::vector<Words> names_;
  std::vector<NameTrial> made_;
  Random random_{2026};
};

} // namespace

std::vector<NameTrial> name_trials(const std::vector<std::string>& names) {
  return Trials(names).run(names);
}

std::vector<NameTrial> stranger_trials(const std::vector<std::string>& names) {
  std::vector<NameTrial> made;
  for (std::size_t at = 0; at < names.size(); ++at) {
    std::string said(given_names[at % given_names.size()]);
    const auto words = words_of(names[at]);
    said += ' ';
    // Sharing a last word makes it harder: part of the name is known.
    said += at % 2 == 0 || words.empty()
                ? family_names[at / given_names.size() % family_names.size()]
                : std::string_view(words.back());
    made.push_back({std::move(said), ""});
  }
  return made;
}

} // namespace parlour::tools
