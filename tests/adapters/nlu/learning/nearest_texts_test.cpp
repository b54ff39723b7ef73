#include <gmock/gmock.h>

#include "adapters/nlu/learning/nearest_texts.hpp"

namespace parlour::adapters::nlu {
namespace {

using Words = NearestTexts::Words;

enum Label : std::uint32_t { way, price, printing };

NearestTexts remembered() {
  NearestTexts texts;
  texts.add({"how", "do", "i", "get", "there"}, way);
  texts.add({"where", "is", "@3"}, way);
  texts.add({"how", "much", "is", "it"}, price);
  texts.add({"where", "can", "i", "print"}, printing);
  texts.finish();
  return texts;
}

// The labels, the nearest first.
std::vector<std::uint32_t> labels(const Words& words,
                                  const std::vector<Words>& others = {}) {
  std::vector<std::uint32_t> made;
  for (const auto& near : remembered().find(words, others, 9))
    made.push_back(near.label);
  return made;
}

TEST(NearestTexts, TheSameTextIsWhollyAlike) {
  const auto near = remembered().find({"how", "much", "is", "it"}, {}, 1);
  ASSERT_EQ(near.size(), 1U);
  EXPECT_EQ(near[0].label, price);
  EXPECT_EQ(near[0].text, 2U);
  EXPECT_NEAR(near[0].similarity, 1, 1e-4);
}

TEST(NearestTexts, TextsWithoutALabelAreOnlyComparedWith) {
  NearestTexts texts;
  texts.add({"where", "is", "the", "pool"}, 0);
  for (int time = 0; time < 5; ++time)
    texts.add_other({"who", "owns", "the", "moon"});
  texts.finish();
  EXPECT_TRUE(texts.find({"who", "owns", "moon"}, {}, 3).empty());
  const auto moon = texts.nearness({"who", "owns", "moon"}, {});
  EXPECT_GT(moon.other, moon.labelled);
  const auto pool = texts.nearness({"where", "is", "the", "pool"}, {});
  EXPECT_NEAR(pool.labelled, 1, 1e-4); // there is no other
  EXPECT_LT(pool.other, pool.labelled);
  EXPECT_EQ(texts.nearness({}, {}).other, 0);
}

TEST(NearestTexts, RareWordsCountMore) {
  EXPECT_EQ(labels({"may", "i", "print", "there"})[0], printing);
  const auto more = remembered().find({"much", "is", "it"}, {}, 1)[0];
  const auto less = remembered().find({"how", "is", "it"}, {}, 1)[0];
  EXPECT_GT(more.similarity, less.similarity);
}

TEST(NearestTexts, BeginningsOfWordsCount) {
  EXPECT_EQ(labels({"printing"}), std::vector<std::uint32_t>{printing});
}

TEST(NearestTexts, WordsOfNoTextSpeakAgainstAll) {
  const auto near = [](const Words& words) {
    return remembered().find(words, {}, 1)[0].similarity;
  };
  EXPECT_LT(near({"print", "purple", "cows"}), near({"print"}));
  EXPECT_TRUE(labels({"purple", "cows"}).empty());
  EXPECT_TRUE(labels({}).empty());
}

TEST(NearestTexts, OthersStandForAWordThatNoTextHas) {
  EXPECT_TRUE(labels({"photocopy"}).empty());
  EXPECT_EQ(labels({"photocopy"}, {{"print"}}),
            std::vector<std::uint32_t>{printing});
}

TEST(NearestTexts, AValueIsNeeded) {
  EXPECT_EQ(remembered().find({"where", "is", "@3"}, {}, 1)[0].text, 1U);
  for (const auto& near : remembered().find({"where", "is"}, {}, 9))
    EXPECT_NE(near.text, 1U);
  for (const auto& near : remembered().find({"where", "is", "@4"}, {}, 9))
    EXPECT_NE(near.text, 1U);
}

TEST(NearestTexts, AsManyAsAreWanted) {
  EXPECT_EQ(remembered().find({"how", "is", "i"}, {}, 2).size(), 2U);
  NearestTexts none;
  none.finish();
  EXPECT_TRUE(none.find({"how"}, {}, 2).empty());
}

} // namespace
} // namespace parlour::adapters::nlu
