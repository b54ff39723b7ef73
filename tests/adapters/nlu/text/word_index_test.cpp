#include <gtest/gtest.h>

#include "adapters/nlu/text/word_index.hpp"

namespace parlour::adapters::nlu {
namespace {

TEST(WordIndex, FindsWordsAndMisspellings) {
  WordIndex index;
  const auto jeffery = index.add("jeffery");
  index.add("margaret");
  EXPECT_EQ(index.add("jeffery"), jeffery);
  EXPECT_TRUE(index.find("jefrey", Spelling::exact).empty());
  const auto hits = index.find("jefrey", Spelling::loose);
  ASSERT_EQ(hits.size(), 1U);
  EXPECT_EQ(hits[0].word, jeffery);
  EXPECT_LT(hits[0].similarity, 1);
}

TEST(WordIndex, FindsWordsOfTheSameSound) {
  WordIndex index;
  const auto jeffery = index.add("jeffery");
  const auto loh = index.add("loh");
  index.add("margaret");
  const auto hits = index.find("geoffrey", Spelling::loose);
  ASSERT_EQ(hits.size(), 1U);
  EXPECT_EQ(hits[0].word, jeffery);
  EXPECT_LT(hits[0].similarity, 0.95);
  ASSERT_EQ(index.find("low", Spelling::loose).size(), 1U);
  EXPECT_EQ(index.find("low", Spelling::loose)[0].word, loh);
  EXPECT_TRUE(index.find("geoffrey", Spelling::exact).empty());
}

TEST(WordIndex, FindsLongWordsThatAreNearlyTheSame) {
  WordIndex index;
  const auto joined = index.add("jefferyho");
  index.add("jefferyhopper");
  const auto hits = index.find("jefferryho", Spelling::nearly);
  ASSERT_EQ(hits.size(), 1U);
  EXPECT_EQ(hits[0].word, joined);
  EXPECT_GE(hits[0].similarity, 0.9);
  EXPECT_TRUE(index.find("jeffery", Spelling::nearly).empty());
  EXPECT_TRUE(index.find("jeffariho", Spelling::nearly).empty());
  EXPECT_FALSE(index.find("jeffery", Spelling::loose).empty());
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
