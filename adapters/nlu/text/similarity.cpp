#include "adapters/nlu/text/similarity.hpp"

#include <algorithm>
#include <array>

namespace parlour::adapters::nlu {

namespace {

constexpr std::size_t longest = 32;

constexpr bool is_vowel(char letter) {
  return std::string_view("aeiouy").find(letter) != std::string_view::npos;
}

// Consonants that sound or are written alike.
constexpr bool is_alike(char left, char right) {
  constexpr std::string_view groups[] = {"ckq", "sz", "fv", "bp", "dt",
                                         "gj",  "mn", "lr", "vw", "sx"};
  for (const auto group : groups)
    if (group.find(left) != std::string_view::npos &&
        group.find(right) != std::string_view::npos)
      return true;
  return false;
}

constexpr float change_cost(char left, char right) {
  if (left == right)
    return 0;
  if (is_vowel(left) && is_vowel(right))
    return 0.65F;
  return is_alike(left, right) ? 0.6F : 1;
}

constexpr float extra_cost(char letter) {
  return letter == 'h' || letter == 'e' ? 0.6F : is_vowel(letter) ? 0.8F : 1;
}

constexpr std::size_t letters = 26;

// The costs of letters, looked up.
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

float change(char left, char right) {
  const auto first = static_cast<std::size_t>(left - 'a');
  const auto second = static_cast<std::size_t>(right - 'a');
  if (first < letters && second < letters)
    return costs.change[first][second];
  return left == right ? 0 : 1;
}

// A letter too many or too few, after `before`.
float extra(char letter, char before) {
  if (letter == before)
    return 0.4F;
  const auto place = static_cast<std::size_t>(letter - 'a');
  return place < letters ? costs.extra[place] : 1;
}

using Row = std::array<float, longest + 1>;

char before(std::string_view word, std::size_t position) {
  return position >= 2 ? word[position - 2] : '\0';
}

void fill_row(std::string_view left, std::string_view right, std::size_t i,
              const Row& older, const Row& old, Row& row) {
  row[0] = old[0] + extra(left[i - 1], before(left, i));
  for (std::size_t j = 1; j <= right.size(); ++j) {
    row[j] = std::min({old[j - 1] + change(left[i - 1], right[j - 1]),
                       old[j] + extra(left[i - 1], before(left, i)),
                       row[j - 1] + extra(right[j - 1], before(right, j))});
    if (i > 1 && j > 1 && left[i - 1] == right[j - 2] &&
        left[i - 2] == right[j - 1])
      row[j] = std::min(row[j], older[j - 2] + 0.6F);
  }
}

float distance(std::string_view left, std::string_view right) {
  Row older, old, row;
  old[0] = 0;
  for (std::size_t j = 1; j <= right.size(); ++j)
    old[j] = old[j - 1] + extra(right[j - 1], before(right, j));
  for (std::size_t i = 1; i <= left.size(); ++i) {
    fill_row(left, right, i, older, old, row);
    std::copy_n(old.begin(), right.size() + 1, older.begin());
    std::copy_n(row.begin(), right.size() + 1, old.begin());
  }
  return old[right.size()];
}

} // namespace

double similarity(std::string_view left, std::string_view right) {
  if (left == right)
    return 1;
  left = left.substr(0, longest);
  right = right.substr(0, longest);
  const auto length = static_cast<double>(std::max(left.size(), right.size()));
  if (left.empty() || right.empty())
    return 0;
  return std::max(0.0, 1 - double(distance(left, right)) / length);
}

double similarity_needed(std::size_t length) {
  return length <= 3 ? 0.79 : length == 4 ? 0.76 : 0.72;
}

std::string did_you_mean(std::string_view word,
                         std::span<const std::string> known) {
  const std::string* best = nullptr;
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
