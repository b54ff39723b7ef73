// Spellings are read from left to right, the longest group of letters first.
// Sounds are small letters; S is "sh", C "ch", and N "ng".
#include "adapters/nlu/text/phones.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include "adapters/nlu/text/letter_groups.hpp"
#include "runtime/text/edit_distance.hpp"

namespace parlour::adapters::nlu {

namespace {

constexpr std::size_t longest = 32;

// At the beginning of a word.
constexpr LetterGroups beginnings(std::to_array<LetterGroup>({{"zh", "j"},
                                                              {"x", "S"},
                                                              {"qu", "kw"},
                                                              {"q", "C"},
                                                              {"kn", "n"},
                                                              {"wr", "r"},
                                                              {"hw", "w"},
                                                              {"nguy", "uN"},
                                                              {"ng", "uN"},
                                                              {"sng", "suN"},
                                                              {"gh", "g"},
                                                              {"y", "y"}}));

// Anywhere else. Of two that fit, the first is taken.
constexpr LetterGroups groups(std::to_array<LetterGroup>(
    {{"tch", "C"},   {"sch", "S"},   {"ch", "C"},   {"sh", "S"},
     {"zh", "j"},    {"dj", "j"},    {"dz", "z"},   {"ts", "z"},
     {"tz", "z"},    {"ph", "f"},    {"th", "t"},   {"kh", "k"},
     {"bh", "b"},    {"dh", "d"},    {"gh", ""},    {"ck", "k"},
     {"wh", "w"},    {"qu", "kw"},   {"ng", "N"},   {"eau", "o"},
     {"iao", "iau"}, {"ooey", "ui"}, {"uey", "ui"}, {"oui", "ui"},
     {"wei", "wei"}, {"eye", "ai"},  {"igh", "ai"}, {"ai", "ai"},
     {"ei", "ei"},   {"ay", "ei"},   {"ey", "ei"},  {"ao", "au"},
     {"au", "au"},   {"aw", "o"},    {"ow", "ou"},  {"ou", "ou"},
     {"oa", "o"},    {"ee", "i"},    {"ea", "i"},   {"ie", "ie"},
     {"oo", "u"},    {"ew", "iu"},   {"ue", "ue"},  {"ui", "ui"},
     {"uh", "u"},    {"ah", "a"},    {"oh", "o"},   {"eh", "e"},
     {"ih", "i"},    {"er", "er"}}));

constexpr bool is_vowel(char phone) {
  constexpr LetterSet vowels("aeiou");
  return vowels.contains(phone);
}

bool is_soft(char letter) {
  return letter == 'e' || letter == 'i' || letter == 'y';
}

char phone_of(char letter, char next) {
  switch (letter) {
  case 'c':
    return is_soft(next) ? 's' : 'k';
  case 'q':
    return 'k';
  case 'y':
    return is_vowel(next) ? 'y' : 'i';
  default:
    return letter;
  }
}

class Phones {
public:
  explicit Phones(std::string_view word) : word_(word) {
    made_.reserve(word.size() + 4);
  }

  std::string run() {
    take(beginnings);
    while (at_ < word_.size())
      if (!take(groups))
        take_letter();
    return std::move(made_);
  }

private:
  template <std::size_t size>
  bool take(const LetterGroups<size>& spellings) {
    const auto* const found = spellings.find(word_.substr(at_));
    if (!found)
      return false;
    at_ += found->letters.size();
    for (const char phone : found->sounds)
      add(phone);
    return true;
  }

  // A silent "e" ends a word with another vowel: "grace".
  void take_letter() {
    const char letter = word_[at_++];
    const char next = at_ < word_.size() ? word_[at_] : '\0';
    const bool silent = letter == 'e' && next == '\0' && made_.size() > 2 &&
                        !is_vowel(made_.back()) &&
                        std::ranges::any_of(made_, is_vowel);
    if (letter == 'x') {
      add('k');
      add('s');
    } else if (!silent) {
      add(phone_of(letter, next));
    }
  }

  // Doubled sounds are one.
  void add(char phone) {
    if (made_.empty() || made_.back() != phone)
      made_ += phone;
  }

  std::string_view word_;
  std::size_t at_ = 0;
  std::string made_;
};

// -- how alike ----------------------------------------------------------------

struct Pair {
  char left;
  char right;
  float cost;
};

// What one sound costs in the place of another, if it is less than 1.
constexpr Pair pairs[] = {
    {'j', 'C', 0.35F}, {'C', 'S', 0.4F},  {'S', 's', 0.35F}, {'s', 'z', 0.3F},
    {'z', 'j', 0.35F}, {'z', 'C', 0.5F},  {'j', 'S', 0.5F},  {'z', 'S', 0.5F},
    {'C', 's', 0.6F},  {'k', 'g', 0.35F}, {'t', 'd', 0.35F}, {'p', 'b', 0.35F},
    {'f', 'v', 0.35F}, {'v', 'w', 0.35F}, {'b', 'v', 0.6F},  {'m', 'n', 0.4F},
    {'n', 'N', 0.3F},  {'m', 'N', 0.5F},  {'l', 'r', 0.5F},  {'g', 'j', 0.5F},
    {'t', 'C', 0.6F},  {'k', 'h', 0.6F},  {'j', 'y', 0.6F},  {'k', 't', 0.7F},
    {'p', 't', 0.7F},  {'k', 'C', 0.7F},  {'f', 'h', 0.7F},  {'p', 'f', 0.6F},
    {'g', 'd', 0.7F},  {'t', 's', 0.7F},  {'w', 'u', 0.2F},  {'w', 'o', 0.3F},
    {'y', 'i', 0.2F},  {'a', 'e', 0.45F}, {'a', 'o', 0.45F}, {'a', 'u', 0.45F},
    {'e', 'i', 0.4F},  {'o', 'u', 0.35F}, {'i', 'u', 0.65F}, {'e', 'u', 0.5F},
    {'e', 'o', 0.6F},  {'a', 'i', 0.6F},  {'i', 'o', 0.65F}};

// A vowel too many beside another one.
constexpr float between_vowels = 0.3F;

constexpr std::size_t letters = 128;

struct Costs {
  std::array<std::array<float, letters>, letters> change{};
  std::array<float, letters> extra{};

  constexpr Costs() {
    for (std::size_t left = 0; left < letters; ++left) {
      for (std::size_t right = 0; right < letters; ++right)
        change[left][right] = left == right ? 0.0F : 1.0F;
      extra[left] = 1;
    }
    for (const auto& [left, right, cost] : pairs)
      change[index(left)][index(right)] = change[index(right)][index(left)] =
          cost;
    for (const char vowel : {'a', 'e', 'i', 'o', 'u'})
      extra[index(vowel)] = 0.5F;
    for (const char weak : {'h', 'w', 'y', 'r'})
      extra[index(weak)] = 0.45F;
    for (const char final : {'t', 'k', 'd', 'g', 'p'})
      extra[index(final)] = 0.8F;
  }
  static constexpr std::size_t index(char phone) {
    return static_cast<unsigned char>(phone) % letters;
  }
};

constexpr Costs costs;

// -- at most how alike --------------------------------------------------------

constexpr std::string_view all_phones = "abcdefghijklmnopqrstuvwxyzSCN";

constexpr std::uint32_t bit_of(char phone) {
  return std::uint32_t{1} << all_phones.find(phone);
}

// What a sound costs at least that the other word lacks: in the place of
// another one like it, or else.
struct Lack {
  std::uint32_t relatives = 0;
  float beside_relative = 1;
  float alone = 1;
};

constexpr auto lacks = [] {
  std::array<Lack, all_phones.size()> made;
  for (std::size_t at = 0; at < made.size(); ++at) {
    auto& lack = made[at];
    const auto index = Costs::index(all_phones[at]);
    lack.alone = is_vowel(all_phones[at]) ? between_vowels : costs.extra[index];
    lack.beside_relative = lack.alone;
    for (const char other : all_phones) {
      const auto cost = costs.change[index][Costs::index(other)];
      if (other == all_phones[at] || cost >= lack.alone)
        continue;
      lack.relatives |= bit_of(other);
      lack.beside_relative = std::min(lack.beside_relative, cost);
    }
  }
  return made;
}();

// What it costs at least that `other` lacks sounds of `word`.
float cost_of_lacks(std::uint32_t word, std::uint32_t other) {
  float cost = 0;
  for (auto lacking = word & ~other; lacking != 0; lacking &= lacking - 1) {
    const auto& lack =
        lacks[static_cast<std::size_t>(std::countr_zero(lacking))];
    cost += (lack.relatives & other) != 0 ? lack.beside_relative : lack.alone;
  }
  return cost;
}

// At the beginning of a word a sound too many is another word: "alvin" is not
// "kelvin".
struct PhoneCosts {
  using Number = float;
  static constexpr float swapped = 0.8F;

  static float change(char left, char right) {
    return costs.change[Costs::index(left)][Costs::index(right)];
  }
  static float extra(char phone, char before) {
    const auto cost = costs.extra[Costs::index(phone)];
    if (before == '\0')
      return cost < 1 ? cost + 0.15F : 1.3F;
    return is_vowel(phone) && is_vowel(before) ? between_vowels : cost;
  }
};

// One letter for each kind of consonant; 0: it comes and goes, or is a vowel.
char kind_of(char phone) {
  switch (phone) {
  case 'j':
  case 'C':
  case 'S':
  case 's':
  case 'z':
    return 's';
  case 'k':
  case 'g':
    return 'k';
  case 't':
  case 'd':
    return 't';
  case 'p':
  case 'b':
  case 'f':
  case 'v':
    return 'p';
  case 'm':
  case 'n':
  case 'N':
    return 'n';
  case 'l':
  case 'r':
    return 'l';
  default:
    return '\0';
  }
}

} // namespace

std::string phones_of(std::string_view word) {
  const bool is_plain = std::ranges::all_of(
      word, [](char letter) { return letter >= 'a' && letter <= 'z'; });
  return is_plain ? Phones(word).run() : std::string();
}

double sounds_alike(std::string_view left, std::string_view right,
                    double least) {
  if (left.empty() || right.empty())
    return 0;
  if (left == right)
    return 1;
  return edit_similarity<longest, PhoneCosts>(left, right, least);
}

std::uint32_t sounds_in(std::string_view phones) {
  std::uint32_t all = 0;
  for (const char phone : phones.substr(0, longest))
    all |= bit_of(phone);
  return all;
}

double sounds_alike_at_most(std::uint32_t left, std::uint32_t right,
                            std::size_t length) {
  constexpr double tolerance = 1e-4; // distances are sums of decimals
  const auto cost =
      std::max(cost_of_lacks(left, right), cost_of_lacks(right, left));
  return 1 - (double(cost) - tolerance) /
                 static_cast<double>(std::min(length, longest));
}

std::string outline_of(std::string_view phones) {
  std::string made;
  for (const char phone : phones)
    if (const char kind = kind_of(phone);
        kind != '\0' && (made.empty() || made.back() != kind))
      made += kind;
  return made;
}

} // namespace parlour::adapters::nlu
