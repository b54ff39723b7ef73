// How far two hypotheses of the same words agree: the confidence of a
// recogniser that has none of its own. Pure.
#pragma once

#include <string>
#include <vector>

namespace parlour::adapters::asr {

struct Agreement {
  // 1: the same words; 0: none in common.
  double value = 0;
  // For each word of the first, whether the second has it there.
  std::vector<bool> agreed;
};

// By the alignment with the fewest differences (insertions, deletions,
// substitutions). Two empty hypotheses agree in nothing.
// "coffee shop please" and "coffee shops please" agree by two of three words.
Agreement agreement(const std::vector<std::string>& first,
                    const std::vector<std::string>& second);

// The fewest differences between the two.
std::size_t differences(const std::vector<std::string>& first,
                        const std::vector<std::string>& second);

} // namespace parlour::adapters::asr
