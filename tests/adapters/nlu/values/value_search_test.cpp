#include <gtest/gtest.h>

#include "adapters/nlu/values/value_search.hpp"

namespace parlour::adapters::nlu {
namespace {

class ValueSearchTest : public testing::Test {
protected:
  // The best match of all; `plain` are positions of words that have a meaning
  // of their own.
  ValueMatch best(const std::string& text,
                  std::initializer_list<std::size_t> plain = {}) {
    const auto tokens = tokenize(text);
    std::vector<bool> marks(tokens.list.size(), false);
    for (const auto at : plain)
      marks[at] = true;
    ValueMatch found;
    found.confidence = 0;
    for (auto& match : ValueSearch(index, tokens, marks).run())
      if (match.end - match.begin > found.end - found.begin ||
          match.confidence > found.confidence)
        found = match;
    return found;
  }

  ValueIndex index;
  SetId staff = index.add({"Jeffery Ho", "Tan Wei Ming", "Nurul binte Ahmad"});
  SetId places = index.add({"food court", "bank of China", "gate 12"});
};

TEST_F(ValueSearchTest, FindsWholeValues) {
  const auto match = best("to meet jeffery ho now");
  EXPECT_EQ(match.set, staff);
  EXPECT_EQ(match.begin, 2U);
  EXPECT_EQ(match.end, 4U);
  EXPECT_EQ(match.confidence, 1);
  EXPECT_TRUE(match.whole);
  EXPECT_TRUE(match.stands_alone);
}

TEST_F(ValueSearchTest, TakesNoWordThatLeadsInForAPartOfAValue) {
  index.add({"fish and chips"});
  EXPECT_EQ(best("and chips").begin, 1U);
  EXPECT_EQ(best("fish and chips").begin, 0U);
}

TEST_F(ValueSearchTest, TakesNoWordLikeOneForAPartOfAValue) {
  index.add({"living room"});
  EXPECT_GT(best("living").confidence, 0.8);
  EXPECT_GT(best("livving room").confidence, 0.8);
  EXPECT_EQ(best("giving").confidence, 0);
}

TEST_F(ValueSearchTest, DoubtsAWordThatNamesNothing) {
  index.add({"the time machine"});
  EXPECT_LT(best("the times", {0, 1}).confidence, 0.7);
  EXPECT_GT(best("the machine", {0, 1}).confidence, 0.9);
  EXPECT_EQ(best("the time machine", {0, 1, 2}).confidence, 1);
}

// Nor is a number alone a place that it is a part of the name of.
TEST_F(ValueSearchTest, TakesNoNumberForAPartOfAValue) {
  index.add({"Second Floor Toilets"});
  EXPECT_EQ(best("one second first tell me").confidence, 0);
  EXPECT_GT(best("the second floor toilets").confidence, 0.9);
}

TEST_F(ValueSearchTest, NeedsNoLightWords) {
  EXPECT_TRUE(best("bank china").whole);
  EXPECT_TRUE(best("nurul ahmad").whole);
  EXPECT_EQ(best("bank of the china").end, 4U); // one more between
  EXPECT_EQ(best("of").confidence, 0);
}

TEST_F(ValueSearchTest, TakesNoPlainWordForAPartOfAValue) {
  index.add({"Journey to the Centre", "The Three Musketeers"});
  EXPECT_EQ(best("to").confidence, 0);
  EXPECT_EQ(best("three").confidence, 0);
  EXPECT_GT(best("journey").confidence, 0);
  EXPECT_TRUE(best("the three musketeers").whole);
}

TEST_F(ValueSearchTest, IsLessSureOfMisspeltWords) {
  const auto match = best("jefery ho");
  EXPECT_EQ(match.set, staff);
  EXPECT_LT(match.confidence, 1);
  EXPECT_GT(match.confidence, 0.8);
  EXPECT_EQ(best("jefery", {0}).confidence, 0); // means something else
  EXPECT_EQ(best("gate 13").whole, false);      // numbers are not misspelt
}

TEST_F(ValueSearchTest, AFirstNameStandsAloneUnlessItMeansSomethingElse) {
  EXPECT_TRUE(best("jeffery").stands_alone);
  EXPECT_FALSE(best("jeffery").whole);
  EXPECT_FALSE(best("court", {0}).stands_alone);
}

TEST_F(ValueSearchTest, DoesNotReachBeyondASentence) {
  EXPECT_FALSE(best("food. court").whole);
  EXPECT_TRUE(best("food, court").whole);
}

TEST_F(ValueSearchTest, KeepsNoMoreCandidatesThanFifty) {
  std::vector<std::string> names;
  for (int number = 0; number < 80; ++number)
    names.push_back("Lim Person" + std::to_string(number));
  const auto people = index.add(names);
  const auto match = best("lim");
  EXPECT_EQ(match.set, people);
  EXPECT_EQ(match.values.size(), 50U);
}

// From ten names on, a set is one of people: then a word that is left over
// means somebody else.
class PeopleTest : public ValueSearchTest {
protected:
  std::string name(const std::string& text,
                   std::initializer_list<std::size_t> plain = {}) {
    const auto match = best(text, plain);
    return match.set == people && match.values.size() == 1
               ? index.value(people, match.values[0])
               : "";
  }

  SetId people = index.add({"Kelvin Tan", "Joanna Soh", "Grace Lim Xiu Ying",
                            "Chua Zhi Hao", "Quek Mei Ling", "Arun s/o Kumar",
                            "Nora binte Ahmad", "Edwin Goh",
                            "Patrick Ng Wei Ming", "Alan Shaw"});
};

TEST_F(PeopleTest, AreFoundByTheirSound) {
  EXPECT_EQ(name("joana so", {1}), "Joanna Soh");
  EXPECT_EQ(name("grace lim shew ying"), "Grace Lim Xiu Ying");
  EXPECT_EQ(name("kweck may ling"), "Quek Mei Ling");
  EXPECT_EQ(name("edween goh"), "Edwin Goh");
  EXPECT_EQ(name("patrick ung waiming"), "Patrick Ng Wei Ming");
}

TEST_F(PeopleTest, AreFoundInPartsAndWithNoise) {
  EXPECT_EQ(name("zhi hao chua"), "Chua Zhi Hao");
  EXPECT_EQ(name("arun son of er kumar"), "Arun s/o Kumar");
  EXPECT_EQ(name("kelvin tan t a n"), "Kelvin Tan");
  EXPECT_EQ(name("missus grace xiu ying"), "Grace Lim Xiu Ying");
}

TEST_F(PeopleTest, AreNotTakenForSomebodyElse) {
  EXPECT_EQ(name("alvin mueller"), "");
  EXPECT_EQ(name("kelvin mueller"), "");
  EXPECT_EQ(name("nora binte kassim"), "");
  EXPECT_EQ(name("daniel chua zhi hao"), "");
  EXPECT_EQ(name("arun son of perumal"), "");
  index.add({"Walt Whitman", "Jane Austen", "Mark Twain", "Mary Shelley",
             "Bram Stoker", "Emily Bronte", "Leo Tolstoy", "George Eliot",
             "Henry James", "Lewis Carroll"});
  EXPECT_EQ(best("asthma").confidence, 0);
  EXPECT_EQ(best("walk").confidence, 0);
  EXPECT_GT(best("wallt").confidence, 0.8);
}

} // namespace
} // namespace parlour::adapters::nlu
