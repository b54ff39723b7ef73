#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "adapters/nlu/text/phones.hpp"

namespace parlour::adapters::nlu {
namespace {

double alike(const char* left, const char* right) {
  return sounds_alike(phones_of(left), phones_of(right));
}

TEST(Phones, ReadHowNamesAreWritten) {
  EXPECT_EQ(phones_of("xiu"), "Siu");
  EXPECT_EQ(phones_of("quek"), "kwek");
  EXPECT_EQ(phones_of("ng"), "uN");
  EXPECT_EQ(phones_of("grace"), "gras");
  EXPECT_EQ(phones_of("b1"), "");
  EXPECT_EQ(phones_of(""), "");
}

TEST(Phones, AreAlikeInDifferentSpellings) {
  EXPECT_EQ(alike("zhang", "jang"), 1);
  EXPECT_EQ(alike("xiu", "shew"), 1);
  EXPECT_EQ(alike("hui", "hooey"), 1);
  EXPECT_EQ(alike("phua", "fua"), 1);
  EXPECT_GT(alike("qian", "chien"), 0.85);
  EXPECT_GT(alike("subramaniam", "subramanian"), 0.95);
  EXPECT_GT(alike("jeffery", "geoffrey"), 0.75);
  EXPECT_GT(alike("hwee", "wee"), 0.95);
}

TEST(Phones, DifferInOtherWords) {
  EXPECT_LT(alike("alvin", "kelvin"), 0.8);
  EXPECT_LT(alike("ming", "jie"), 0.5);
  EXPECT_LT(alike("kenneth", "kwok"), 0.5);
  EXPECT_EQ(sounds_alike("", "lim"), 0);
}

TEST(Phones, AreNeverMoreAlikeThanTheirSoundsAllow) {
  const std::vector<std::string> words{
      "zhang",  "jang",    "hui",    "hooey",   "subramaniam", "geoffrey",
      "kwok",   "alvin",   "kelvin", "ming",    "jie",         "kenneth",
      "wee",    "hwee",    "xiu",    "michael", "quek",        "ai",
      "aishah", "meeting", "ng",     "yusoff",  "joseph",      "tan"};
  for (const auto& left : words)
    for (const auto& right : words) {
      const auto one = phones_of(left);
      const auto other = phones_of(right);
      EXPECT_LE(sounds_alike(one, other),
                sounds_alike_at_most(sounds_in(one), sounds_in(other),
                                     std::max(one.size(), other.size())))
          << left << ' ' << right;
    }
}

TEST(Phones, AreKnownNotToBeAlikeByTheirSounds) {
  EXPECT_LT(sounds_alike_at_most(sounds_in("ken"), sounds_in("Sila"), 4), 0.4);
  EXPECT_GE(sounds_alike_at_most(sounds_in("tik"), sounds_in("kit"), 3), 1);
}

TEST(Phones, ShareAnOutlineIfOneMayBeWrittenForTheOther) {
  EXPECT_EQ(outline_of(phones_of("zhang")), outline_of(phones_of("jang")));
  EXPECT_EQ(outline_of(phones_of("quek")), outline_of(phones_of("keck")));
  EXPECT_NE(outline_of(phones_of("tan")), outline_of(phones_of("lim")));
  EXPECT_EQ(outline_of("ai"), "");
}

} // namespace
} // namespace parlour::adapters::nlu
