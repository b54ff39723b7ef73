#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/asr/words/packed_trigrams.hpp"

namespace parlour::adapters::asr {
namespace {

std::uint32_t number_at(const std::string& bytes, std::size_t index) {
  std::uint32_t number = 0;
  std::memcpy(&number, bytes.data() + 4 * index, sizeof number);
  return number;
}

TEST(PackedTrigrams, AreArraysOneAfterTheOther) {
  Symbols symbols;
  TrigramCounts counts;
  counts.add({symbols.word("tea"), symbols.word("don't")});
  const auto bytes = packed(counts, symbols, 0);
  // Words: tea, dont, end, begin. Pairs: begin tea, tea dont, dont end.
  EXPECT_EQ(number_at(bytes, 0), 4u);
  EXPECT_EQ(number_at(bytes, 1), 3u);
  EXPECT_EQ(number_at(bytes, 2), 2u);
  const std::string texts = "tea\ndont\n</s>\n<s>\n";
  EXPECT_EQ(number_at(bytes, 3), 20u);
  EXPECT_EQ(bytes.substr(16, texts.size()), texts);
  // Behind the words' probabilities: where the pairs begin, their words.
  const auto pairs = (16 + 20) / 4 + 2 * 4;
  const std::vector<std::uint32_t> begins{0, 1, 2, 2, 3, 1, 2, 0};
  for (std::size_t i = 0; i < begins.size(); ++i)
    EXPECT_EQ(number_at(bytes, pairs + i), begins[i]) << i;
  const auto numbers = 4 + 5 + 4 * 2 + (5 + 3 * 3) + (4 + 2 * 2);
  EXPECT_EQ(bytes.size(), 4u * numbers);
}

TEST(PackedTrigrams, WordsThatBecomeTheSameAreOne) {
  Symbols symbols;
  TrigramCounts counts;
  counts.add({symbols.word("a.m.")});
  counts.add({symbols.word("am")});
  counts.add({symbols.word("\u00c1m\u2019")});
  const auto bytes = packed(counts, symbols, 0);
  EXPECT_EQ(number_at(bytes, 0), 3u);
  EXPECT_THAT(bytes, testing::HasSubstr("am\n</s>\n<s>\n"));
}

} // namespace
} // namespace parlour::adapters::asr
