#include <gtest/gtest.h>

#include "adapters/nlu/values/value_index.hpp"

namespace parlour::adapters::nlu {
namespace {

// The values of the longest match that begins first, joined by "|".
std::string find(const char* text) {
  ValueIndex index;
  const auto set =
      index.add({"Jeffery Ho", "Ho Hui Min", "Tan Hui Min", "Tan Wei Ming",
                 "Nurul Huda binte Ahmad", "coffee shop", "Ya Kun Toastwich",
                 "coffee shop"});
  const auto tokens = tokenize(text);
  const std::vector<bool> plain(tokens.list.size(), false);
  const ValueMatch* best = nullptr;
  const auto matches = index.find(tokens, plain);
  for (const auto& match : matches)
    if (!best || (match.begin == best->begin && match.end > best->end))
      best = &match;
  std::string names;
  for (std::size_t at = 0; best && at < best->values.size(); ++at)
    names += (at > 0 ? "|" : "") + index.value(set, best->values[at]);
  return names;
}

TEST(ValueIndex, FindsWordsInAnyOrder) {
  EXPECT_EQ(find("Jeffery Ho"), "Jeffery Ho");
  EXPECT_EQ(find("ho jeffery"), "Jeffery Ho");
  EXPECT_EQ(find("Wei Ming Tan"), "Tan Wei Ming");
  EXPECT_EQ(find("nurul huda ahmad"), "Nurul Huda binte Ahmad");
}

TEST(ValueIndex, FindsOtherWordsForThoseOfSmallLetters) {
  ValueIndex index;
  const auto set =
      index.add({"blue cup", "red cup", "newspaper", "Cup Noodle"});
  index.add_synonyms({{"cup", "mug"}, {"newspaper", "paper"}, {"to", "red"}});
  const auto found = [&](const char* text) {
    const auto tokens = tokenize(text);
    std::string names;
    for (const auto& match :
         index.find(tokens, std::vector<bool>(tokens.list.size(), false)))
      if (match.confidence < 1)
        for (const auto value : match.values)
          names += index.value(set, value) + ";";
    return names;
  };
  EXPECT_EQ(found("the paper"), "newspaper;");
  EXPECT_EQ(found("mug"), "blue cup;red cup;");
  EXPECT_EQ(found("to"), "");
  EXPECT_EQ(found("mugg"), ""); // exactly
}

TEST(ValueIndex, TellsThingsFromPeople) {
  ValueIndex index;
  const auto shops = index.add({"Harbour Coffee", "Bright Steps", "Ya Kun"});
  EXPECT_FALSE(index.has_things(shops));
  const auto kinds = index.add({"coffee shop", "bank", "tan", "recycling bin"});
  const auto people = index.add({"Jeffery Ho", "Tan Wei Ming"});
  EXPECT_TRUE(index.has_things(shops));
  EXPECT_TRUE(index.has_things(kinds));
  EXPECT_FALSE(index.has_things(people));
}

TEST(ValueIndex, KeepsCandidates) {
  EXPECT_EQ(find("Hui Min"), "Ho Hui Min|Tan Hui Min");
  EXPECT_EQ(find("Ho"), "Jeffery Ho|Ho Hui Min");
}

TEST(ValueIndex, ForgivesSpelling) {
  EXPECT_EQ(find("jefrey ho"), "Jeffery Ho");
  EXPECT_EQ(find("tan weiming"), "Tan Wei Ming");
  EXPECT_EQ(find("ya kun toast wich"), "Ya Kun Toastwich");
  EXPECT_EQ(find("coffee shops"), "coffee shop");
  EXPECT_EQ(find("coffe shop"), "coffee shop");
}

TEST(ValueIndex, JoinsNoFunctionWordWithALetter) {
  ValueIndex index;
  index.add({"Nguyen Thi Phuong Anh", "An Drew"});
  const auto found = [&](const char* text) {
    const auto tokens = tokenize(text);
    return !index.find(tokens, std::vector<bool>(tokens.list.size(), true))
                .empty();
  };
  EXPECT_FALSE(found("with an h"));
  EXPECT_TRUE(found("phuong anh"));
  EXPECT_TRUE(found("andrew"));
}

TEST(ValueIndex, RejectsStrangers) {
  EXPECT_EQ(find("Zzyzx Qwert"), "");
  EXPECT_EQ(find("Jeffery Smith"), "");
  EXPECT_EQ(find("Jeffery Tan"), "");
}

} // namespace
} // namespace parlour::adapters::nlu
