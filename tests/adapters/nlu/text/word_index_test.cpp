#include <gtest/gtest.h>

#include "adapters/nlu/text/word_index.hpp"

namespace parlour::adapters::nlu {
namespace {

TEST(WordIndex, FindsWordsAndMisspellings) {
  WordIndex index;
  const auto jeffery = index.add("jeffery");
  index.add("margaret");
  EXPECT_EQ(index.add("jeffery"), jeffery);
  EXPECT_TRUE(index.find("jefrey", false).empty());
  const auto hits = index.find("jefrey", true);
  ASSERT_EQ(hits.size(), 1U);
  EXPECT_EQ(hits[0].word, jeffery);
  EXPECT_LT(hits[0].similarity, 1);
}

TEST(WordIndex, FindsWordsOfTheSameSound) {
  WordIndex index;
  const auto jeffery = index.add("jeffery");
  const auto loh = index.add("loh");
  index.add("margaret");
  const auto hits = index.find("geoffrey", true);
  ASSERT_EQ(hits.size(), 1U);
  EXPECT_EQ(hits[0].word, jeffery);
  EXPECT_LT(hits[0].similarity, 0.95);
  ASSERT_EQ(index.find("low", true).size(), 1U);
  EXPECT_EQ(index.find("low", true)[0].word, loh);
  EXPECT_TRUE(index.find("geoffrey", false).empty());
}

TEST(WordIndex, FindsWordsThatAreSaidTheSame) {
  WordIndex index;
  const auto soh = index.add("soh");
  index.add("seah");
  const auto hits = index.find_said_alike("so");
  ASSERT_EQ(hits.size(), 1U);
  EXPECT_EQ(hits[0].word, soh);
  EXPECT_LT(hits[0].similarity, 1);
  EXPECT_TRUE(index.find_said_alike("b1").empty());
}

TEST(WordIndex, TakesOneForMany) {
  EXPECT_EQ(singular("shops"), "shop");
  EXPECT_EQ(singular("pharmacies"), "pharmacy");
  EXPECT_EQ(singular("lunches"), "lunch");
  EXPECT_EQ(singular("bus"), "bus");
  EXPECT_EQ(singular("glass"), "glass");
}

} // namespace
} // namespace parlour::adapters::nlu
