#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "adapters/nlu/values/heard_names.hpp"

namespace parlour::adapters::nlu {
namespace {

const std::vector<std::string> staff{
    "Rajesh s/o Chandran", "Quek Xue Qing",      "Koh Sok Hwee",
    "Katherine Neo",       "Catherine Neo",      "Koh Ming Hui",
    "Goh Ming Hui",        "Jeffery Ho",         "Devi d/o Govindasamy",
    "Kelvin Palmer",       "Grace Chen",         "Ng Eng Hng",
    "Lorraine Goh",        "Vijay s/o Chandran", "Foo Lay Peng",
    "Chia Lay Peng"};

// The names found, each behind its words, candidates joined by "|". Words that
// grammars use are "plain".
std::string heard(const char* text,
                  const std::vector<std::string>& names = staff,
                  const std::vector<std::string>& plain = {
                      "i", "am", "to", "see", "the", "correct"}) {
  ValueIndex index;
  const auto set = index.add(names);
  const auto tokens = tokenize(text);
  std::vector<bool> is_plain;
  for (const auto& token : tokens.list)
    is_plain.push_back(std::ranges::find(plain, token.word) != plain.end());
  std::string made;
  for (const auto& match : heard_names(index, set, tokens, is_plain)) {
    made += made.empty() ? "" : "; ";
    made += words_of(text, tokens, match.begin, match.end);
    for (std::size_t at = 0; at < match.values.size(); ++at)
      made += (at > 0 ? "|" : "=") + index.value(set, match.values[at]);
  }
  return made;
}

TEST(HeardNames, AreFoundByTheirSoundsAsAWhole) {
  EXPECT_EQ(heard("Rajesh Seng of Chandran"),
            "Rajesh Seng of Chandran=Rajesh s/o Chandran");
  EXPECT_EQ(heard("to see Kekzu Qing"), "Kekzu Qing=Quek Xue Qing");
  EXPECT_EQ(heard("I am here to see Koh Sok Hui."), "Koh Sok Hui=Koh Sok Hwee");
}

TEST(HeardNames, AreAFewThatSoundAsMuchAlike) {
  EXPECT_EQ(heard("Go Ming Hui"), "Go Ming Hui=Goh Ming Hui|Koh Ming Hui");
}

TEST(HeardNames, AreAlikeInEachOfAsManyWords) {
  EXPECT_EQ(heard("Jeffery Low"), "");
  EXPECT_EQ(heard("Chelvin Palmer"), "Chelvin Palmer=Kelvin Palmer");
  EXPECT_EQ(heard("Jonathan Palmer"), "");
  // One of three may be otherwise.
  EXPECT_EQ(heard("Wen Xue Qing"), "Wen Xue Qing=Quek Xue Qing");
}

TEST(HeardNames, AreDividedIntoOtherWords) {
  EXPECT_EQ(heard("Vijson of Chandran"),
            "Vijson of Chandran=Vijay s/o Chandran");
  EXPECT_EQ(heard("Cosokwee"), "Cosokwee=Koh Sok Hwee");
  // Words of names are two people's.
  EXPECT_EQ(heard("Jeffery Peng"), "");
}

// The given name is enough to ask which of them.
TEST(HeardNames, BeginWithNoPlainWordBeforeWordsOfNames) {
  const std::vector<std::string> plain{"to", "see", "you", "few"};
  EXPECT_EQ(heard("to see you, Lay Peng", staff, plain), "");
  EXPECT_EQ(heard("to see few Lay Peng", staff, plain),
            "few Lay Peng=Foo Lay Peng");
}

TEST(HeardNames, OfTheSameSoundAreAllMeant) {
  ValueIndex index;
  const auto set = index.add(staff);
  const auto all = [&](const char* text) {
    const auto tokens = tokenize(text);
    std::string names;
    for (auto match : index.find(tokens, std::vector<bool>(16, false))) {
      add_names_of_the_same_sound(index, match);
      for (const auto value : match.values)
        names += (names.empty() ? "" : "|") + index.value(set, value);
    }
    return names;
  };
  EXPECT_EQ(all("Catherine Neo"), "Catherine Neo|Katherine Neo");
  EXPECT_EQ(all("Katherine Neo"), "Katherine Neo|Catherine Neo");
  EXPECT_EQ(all("Goh Ming Hui"), "Goh Ming Hui"); // "Koh" is another sound
}

TEST(HeardNames, AreOfThoseWhoseFirstWordWasHeard) {
  EXPECT_EQ(heard("Lorraine Gove"), "Lorraine Gove=Lorraine Goh");
  EXPECT_EQ(heard("Lorraine Marsh"), "");
  EXPECT_EQ(heard("Lorraine Ho"), ""); // somebody else's
  EXPECT_EQ(heard("Gove Lorraine"), "");
  const std::vector<std::string> plain{"gove"};
  EXPECT_EQ(heard("Lorraine Gove", staff, plain), "");
}

TEST(HeardNames, AreNotWhatSoundsUnlike) {
  EXPECT_EQ(heard("where is the coffee shop"), "");
  EXPECT_EQ(heard("I have an appointment with John Smith"), "");
  EXPECT_EQ(heard(""), "");
}

TEST(HeardNames, AreNoPlainWords) {
  const std::vector<std::string> plain{"correct", "koh", "sok", "hui"};
  EXPECT_EQ(heard("Koh Sok Hui", staff, plain), "");
  EXPECT_EQ(heard("yes correct", staff, {"yes", "correct"}), "");
}

TEST(HeardNames, AreNotOfWhoSpeaks) {
  EXPECT_EQ(heard("I am Koh Sok Hui"), "");
  EXPECT_EQ(heard("my name is Koh Sok Hui"), "");
}

TEST(HeardNames, EndWithTheirSentenceAndBeforeNumbers) {
  EXPECT_EQ(heard("Rajesh. Seng. Of. Chandran"), "");
  EXPECT_EQ(heard("Koh Sok Hui 10:30"), "Koh Sok Hui=Koh Sok Hwee");
  EXPECT_EQ(heard("10:30 Koh Sok Hui"), "Koh Sok Hui=Koh Sok Hwee");
}

TEST(HeardNames, AreOfPeopleAlone) {
  EXPECT_EQ(heard("Koh Sok Hui", {"Koh Sok Hwee", "Jeffery Ho"}), "");
  ValueIndex index;
  auto names = staff;
  for (auto& name : names)
    name += " Coffee";
  const auto set = index.add(names);
  index.add({"coffee shop"});
  EXPECT_TRUE(heard_names(index, set, tokenize("Koh Sok Hui Coffee"),
                          std::vector<bool>(4, false))
                  .empty());
}

// 20,000 names, and as many words as an utterance has, end soon.
TEST(HeardNames, AreLookedForInBoundedTime) {
  std::vector<std::string> names;
  for (int i = 0; i < 20'000; ++i) {
    std::string name{"Ba"};
    for (int rest = i; rest > 0; rest /= 20)
      name += std::string(1, static_cast<char>('a' + rest % 20)) + "o";
    names.push_back(name + " Koh");
  }
  ValueIndex index;
  const auto set = index.add(names);
  std::string text;
  for (int i = 0; i < 200; ++i)
    text += "zork ";
  const auto tokens = tokenize(text);
  EXPECT_TRUE(heard_names(index, set, tokens,
                          std::vector<bool>(tokens.list.size(), false))
                  .empty());
}

} // namespace
} // namespace parlour::adapters::nlu
