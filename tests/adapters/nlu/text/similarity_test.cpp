#include <algorithm>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "adapters/nlu/text/similarity.hpp"

namespace parlour::adapters::nlu {
namespace {

bool is_misspelt(std::string_view left, std::string_view right) {
  return similarity(left, right) >=
         similarity_needed(std::min(left.size(), right.size()));
}

TEST(Similarity, TakesMisspellings) {
  EXPECT_EQ(similarity("ho", "ho"), 1);
  for (const auto& [left, right] :
       {std::pair("jeffery", "jeffrey"), std::pair("hoe", "ho"),
        std::pair("catherine", "katherine"), std::pair("menon", "mennon"),
        std::pair("stephen", "stefen")})
    EXPECT_TRUE(is_misspelt(left, right)) << left << ' ' << right;
}

TEST(Similarity, RejectsOtherWords) {
  for (const auto& [left, right] :
       {std::pair("tan", "ten"), std::pair("lim", "kim"),
        std::pair("jeffery", "jennifer"), std::pair("bank", "bunk bed"),
        std::pair("", "a")})
    EXPECT_FALSE(is_misspelt(left, right)) << left << ' ' << right;
}

TEST(Similarity, NeverExceedsWhatTheLettersAllow) {
  const std::vector<std::string> words{
      "jeffery",
      "jeffrey",
      "jennifer",
      "tan",
      "ten",
      "zzz",
      "hehehe",
      "a",
      "catherine",
      "katherine",
      "über",
      "aaaa",
      "a-very-long-word-of-more-than-32-bytes"};
  for (const auto& left : words)
    for (const auto& right : words) {
      EXPECT_LE(similarity(left, right),
                similarity_at_most(letters_in(left), letters_in(right),
                                   std::max(left.size(), right.size())))
          << left << ' ' << right;
      // Where less is needed, it is told as it is.
      for (const double least : {0.3, 0.72, 0.79})
        if (similarity(left, right) >= least)
          EXPECT_EQ(similarity(left, right, least), similarity(left, right));
        else
          EXPECT_LT(similarity(left, right, least), least);
    }
}

TEST(Similarity, SuggestsTheNearestName) {
  const std::vector<std::string> known{"Host", "Visitor"};
  EXPECT_EQ(did_you_mean("Hots", known), ", did you mean 'Host'?");
  EXPECT_EQ(did_you_mean("Banana", known), "");
}

} // namespace
} // namespace parlour::adapters::nlu
