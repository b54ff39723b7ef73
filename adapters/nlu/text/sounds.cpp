#include "adapters/nlu/text/sounds.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "adapters/nlu/text/letter_groups.hpp"

namespace parlour::adapters::nlu {

namespace {

// Of words up to this length vowels count: "lee" is not "lau"; and of those
// with fewer consonants: "cinema" is not "singh".
constexpr std::size_t short_word = 4;
constexpr std::size_t few_consonants = 3;

// Letters that together are one sound, the longest first; at the beginning of a
// word others as well.
constexpr LetterGroups beginnings(
    std::to_array<LetterGroup>({{"kn", "n"}, {"wr", "r"}, {"gh", "g"}}));
constexpr LetterGroups letter_groups(std::to_array<LetterGroup>({{"tch", "c"},
                                                                 {"sch", "x"},
                                                                 {"ph", "f"},
                                                                 {"gh", ""},
                                                                 {"ck", "k"},
                                                                 {"ch", "c"},
                                                                 {"sh", "x"},
                                                                 {"zh", "j"},
                                                                 {"th", "t"},
                                                                 {"wh", "w"},
                                                                 {"kh", "k"},
                                                                 {"qu", "k"},
                                                                 {"ts", "s"},
                                                                 {"tz", "s"},
                                                                 {"dg", "j"},
                                                                 {"ng", "n"}}));

bool is_vowel(char letter) {
  constexpr LetterSet vowels("aeiouy");
  return vowels.contains(letter);
}

// "e", "i" and "y" make "c" and "g" soft.
bool is_soft(char letter) {
  return letter == 'e' || letter == 'i' || letter == 'y';
}

char vowel_sound(char letter) {
  return letter == 'a' ? 'a' : is_soft(letter) ? 'i' : 'o';
}

char consonant_sound(char letter, char next) {
  switch (letter) {
  case 'c':
    return is_soft(next) ? 's' : 'k';
  case 'g':
    return is_soft(next) ? 'j' : 'g';
  case 'q':
    return 'k';
  case 'z':
    return 's';
  case 'm':
    return 'n';
  default:
    return letter;
  }
}

class Sounds {
public:
  Sounds(std::string_view word, bool vowels) : word_(word), vowels_(vowels) {}

  std::string run() {
    while (at_ < word_.size())
      if (!take_group())
        take_letter();
    return std::move(made_);
  }

private:
  bool take_group() {
    const auto rest = word_.substr(at_);
    const auto* found = at_ == 0 ? beginnings.find(rest) : nullptr;
    if (!found)
      found = letter_groups.find(rest);
    if (!found)
      return false;
    at_ += found->letters.size();
    for (const char sound : found->sounds)
      add(sound);
    return true;
  }

  void take_letter() {
    const char letter = word_[at_++];
    const char next = at_ < word_.size() ? word_[at_] : '\0';
    const bool is_first = at_ == 1;
    if (is_vowel(letter) && !(is_first && letter == 'y'))
      return take_vowel(letter, is_first);
    // Silent behind a vowel: "hoh", "low".
    if ((letter == 'h' || letter == 'w') && !is_first && !is_vowel(next))
      return;
    if (letter == 'h' && !is_first)
      return;
    add(consonant_sound(letter, next));
  }

  // Only the first of several counts; without vowels, the one at the beginning
  // does.
  void take_vowel(char letter, bool is_first) {
    behind_vowel_ = true;
    if (is_first || vowels_)
      if (made_.empty() || !is_vowel(made_.back()))
        made_ += vowel_sound(letter);
  }

  // Doubled letters are one.
  void add(char sound) {
    if (std::exchange(behind_vowel_, false) || made_.empty() ||
        made_.back() != sound)
      made_ += sound;
  }

  std::string_view word_;
  bool vowels_;
  bool behind_vowel_ = false;
  std::size_t at_ = 0;
  std::string made_;
};

} // namespace

std::string sound_of(std::string_view word) {
  const bool is_plain = std::ranges::all_of(
      word, [](char letter) { return letter >= 'a' && letter <= 'z'; });
  if (!is_plain)
    return {};
  auto sounds = Sounds(word, word.size() <= short_word).run();
  return sounds.size() < few_consonants ? Sounds(word, true).run() : sounds;
}

} // namespace parlour::adapters::nlu
