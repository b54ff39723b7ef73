#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "adapters/nlu/text/word_set.hpp"

namespace parlour::adapters::nlu {
namespace {

using testing::UnorderedElementsAre;

const WordSet& words() {
  static const WordSet made{"a", "tea", "toe", "über",
                            "a-word-that-is-longer-than-thirty-one-letters"};
  return made;
}

TEST(WordSet, has_its_words) {
  for (const auto word : words())
    EXPECT_TRUE(words().contains(word)) << word;
}

TEST(WordSet, has_no_others) {
  for (const auto* word :
       {"", "b", "te", "tie", "teas", "xea", "uber",
        "another-word-that-is-longer-than-thirty-one-letters"})
    EXPECT_FALSE(words().contains(word)) << word;
}

TEST(WordSet, lists_them) {
  const WordSet two{"one", "two"};
  EXPECT_THAT(std::vector<std::string>(two.begin(), two.end()),
              UnorderedElementsAre("one", "two"));
}

TEST(WordMap, finds_what_its_words_mean) {
  const WordMap<int> numbers{{"one", 1}, {"two", 2}};
  ASSERT_NE(numbers.find("two"), nullptr);
  EXPECT_EQ(*numbers.find("two"), 2);
  for (const auto* word : {"", "too", "tw", "three"})
    EXPECT_EQ(numbers.find(word), nullptr) << word;
}

} // namespace
} // namespace parlour::adapters::nlu
