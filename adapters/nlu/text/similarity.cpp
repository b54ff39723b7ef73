#include "adapters/nlu/text/similarity.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include "runtime/text/edit_distance.hpp"

namespace parlour::adapters::nlu {

namespace {

constexpr std::size_t longest = 32;
// Distances are sums of decimals.
constexpr double tolerance = 1e-4;

constexpr bool is_vowel(char letter) {
  return std::string_view("aeiouy").find(letter) != std::string_view::npos;
}

// Consonants that sound alike or look alike.
constexpr bool is_alike(char left, char right) {
  constexpr std::string_view groups[] = {"ckq", "sz", "fv", "bp", "dt",
                                         "gj",  "mn", "lr", "vw", "sx"};
  for (const auto group : groups)
    if (group.find(left) != std::string_view::npos &&
        group.find(right) != std::string_view::npos)
      return true;
  return false;
}

// Of a letter that the other word lacks.
constexpr float least_cost = 0.6F;

// The cost of one letter in the place of another.
constexpr float change_cost(char left, char right) {
  if (left == right)
    return 0;
  if (is_vowel(left) && is_vowel(right))
    return 0.65F;
  return is_alike(left, right) ? least_cost : 1;
}

// The cost of a letter too many or too few. "h" and "e" are often silent.
constexpr float extra_cost(char letter) {
  return letter == 'h' || letter == 'e' ? least_cost
         : is_vowel(letter)             ? 0.8F
                                        : 1;
}

constexpr std::size_t letters = 26;

// The costs of all letters, computed once by the compiler: similarity() runs
// for every candidate of every word.
struct Costs {
  std::array<std::array<float, letters>, letters> change{};
  std::array<float, letters> extra{};

  constexpr Costs() {
    for (std::size_t left = 0; left < letters; ++left) {
      extra[left] = extra_cost(static_cast<char>('a' + left));
      for (std::size_t right = 0; right < letters; ++right)
        change[left][right] = change_cost(static_cast<char>('a' + left),
                                          static_cast<char>('a' + right));
    }
  }
};

constexpr Costs costs;

// Bytes other than a to z are compared as they are; a doubled letter is cheap.
struct SoundCosts {
  using Number = float;
  static constexpr float swapped = 0.6F;

  static float change(char left, char right) {
    const auto first = static_cast<std::size_t>(left - 'a');
    const auto second = static_cast<std::size_t>(right - 'a');
    if (first < letters && second < letters)
      return costs.change[first][second];
    return left == right ? 0 : 1;
  }
  static float extra(char letter, char before) {
    if (letter == before)
      return 0.4F;
    const auto place = static_cast<std::size_t>(letter - 'a');
    return place < letters ? costs.extra[place] : 1;
  }
};

} // namespace

double similarity(std::string_view left, std::string_view right, double least) {
  if (left == right)
    return 1;
  if (left.empty() || right.empty())
    return 0;
  return edit_similarity<longest, SoundCosts>(left, right, least);
}

std::uint32_t letters_in(std::string_view word) {
  std::uint32_t all = 0;
  for (const char letter : word.substr(0, longest))
    if (const auto place = static_cast<std::size_t>(letter - 'a');
        place < letters)
      all |= std::uint32_t{1} << place;
  return all;
}

// A letter that the other word lacks is replaced or left out, which mends one
// of each word at most.
double similarity_at_most(std::uint32_t left, std::uint32_t right,
                          std::size_t length) {
  const auto edits =
      std::max(std::popcount(left & ~right), std::popcount(right & ~left));
  const auto cost = edits * double(least_cost) - tolerance;
  return 1 - cost / static_cast<double>(std::min(length, longest));
}

double similarity_needed(std::size_t length) {
  return length <= 3 ? 0.79 : length == 4 ? 0.76 : 0.72;
}

std::string did_you_mean(std::string_view word,
                         std::span<const std::string> known) {
  const std::string* best = nullptr;
  // Below this a suggestion is more confusing than helpful.
  double score = 0.6;
  for (const auto& one : known) {
    if (const auto alike = similarity(word, one); alike > score) {
      score = alike;
      best = &one;
    }
  }
  return best ? ", did you mean '" + *best + "'?" : std::string();
}

} // namespace parlour::adapters::nlu
