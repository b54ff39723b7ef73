#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "adapters/nlu/values/heard_names.hpp"

namespace parlour::adapters::nlu {
namespace {

const std::vector<std::string> staff{
    "Rajesh s/o Chandran",  "Quek Xue Qing", "Koh Sok Hwee", "Katherine Neo",
    "Catherine Neo",        "Koh Ming Hui",  "Goh Ming Hui", "Jeffery Ho",
    "Devi d/o Govindasamy", "Kelvin Palmer", "Grace Chen",   "Ng Eng Hng"};

// The names found, each behind its words, candidates joined by "|".
std::string heard(const char* text,
                  const std::vector<std::string>& names = staff) {
  ValueIndex index;
  const auto set = index.add(names);
  const auto tokens = tokenize(text);
  std::string made;
  for (const auto& match : heard_names(index, tokens)) {
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
  EXPECT_EQ(heard("to see Kekzu Qing please"), "Kekzu Qing=Quek Xue Qing");
  EXPECT_EQ(heard("I am here to meet Koh Sok Hui."),
            "Koh Sok Hui=Koh Sok Hwee");
  EXPECT_EQ(heard("the Vdotter of Govindasamy"),
            "the Vdotter of Govindasamy=Devi d/o Govindasamy");
}

TEST(HeardNames, AreAFewThatSoundAsMuchAlike) {
  EXPECT_EQ(heard("Go Ming Hui"), "Go Ming Hui=Goh Ming Hui|Koh Ming Hui");
}

TEST(HeardNames, AreNotWhatSoundsUnlike) {
  EXPECT_EQ(heard("where is the coffee shop"), "");
  EXPECT_EQ(heard("I have an appointment with John Smith"), "");
  EXPECT_EQ(heard(""), "");
}

TEST(HeardNames, EndWithTheirSentence) {
  EXPECT_EQ(heard("Rajesh. Seng. Of. Chandran"), "");
}

TEST(HeardNames, AreOfPeopleAlone) {
  EXPECT_EQ(heard("Koh Sok Hui", {"Koh Sok Hwee", "Jeffery Ho"}), "");
  ValueIndex index;
  auto names = staff;
  for (auto& name : names)
    name += " Coffee";
  index.add(names);
  index.add({"coffee shop"});
  EXPECT_TRUE(heard_names(index, tokenize("Koh Sok Hui Coffee")).empty());
}

TEST(Homophones, AreSaidAlike) {
  ValueIndex index;
  const auto set = index.add(staff);
  EXPECT_EQ(homophones(index, set, 3), (std::vector<std::uint32_t>{3, 4}));
  EXPECT_EQ(homophones(index, set, 7), std::vector<std::uint32_t>{7});
}

TEST(Homophones, AreNoneOfThings) {
  ValueIndex index;
  const auto set = index.add({"bank", "Bank"});
  EXPECT_EQ(homophones(index, set, 1), std::vector<std::uint32_t>{1});
}

} // namespace
} // namespace parlour::adapters::nlu
