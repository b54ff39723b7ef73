#include "adapters/asr/words/agreement.hpp"

#include <algorithm>

namespace parlour::adapters::asr {

namespace {

using Words = std::vector<std::string>;
using Table = std::vector<std::vector<std::size_t>>;

// distances[i][j]: of the first i and the first j words.
Table distances(const Words& first, const Words& second) {
  Table table(first.size() + 1, std::vector<std::size_t>(second.size() + 1));
  for (std::size_t i = 0; i <= first.size(); ++i)
    for (std::size_t j = 0; j <= second.size(); ++j)
      if (i == 0 || j == 0)
        table[i][j] = i + j;
      else
        table[i][j] =
            std::min({table[i - 1][j - 1] + (first[i - 1] != second[j - 1]),
                      table[i - 1][j] + 1, table[i][j - 1] + 1});
  return table;
}

} // namespace

std::size_t differences(const Words& first, const Words& second) {
  return distances(first, second).back().back();
}

// Walks back through the table, from the end of both to their beginning.
Agreement agreement(const Words& first, const Words& second) {
  Agreement made;
  made.agreed.resize(first.size());
  const auto table = distances(first, second);
  auto i = first.size();
  auto j = second.size();
  std::size_t same = 0;
  while (i > 0 && j > 0)
    if (first[i - 1] == second[j - 1] && table[i][j] == table[i - 1][j - 1]) {
      made.agreed[--i] = true;
      --j;
      ++same;
    } else if (table[i][j] == table[i - 1][j - 1] + 1) {
      --i;
      --j;
    } else if (table[i][j] == table[i - 1][j] + 1) {
      --i;
    } else {
      --j;
    }
  const auto longer = std::max(first.size(), second.size());
  if (longer > 0)
    made.value = static_cast<double>(same) / static_cast<double>(longer);
  return made;
}

} // namespace parlour::adapters::asr
