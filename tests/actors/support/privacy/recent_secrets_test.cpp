#include <gtest/gtest.h>

#include "actors/support/privacy/recent_secrets.hpp"

namespace parlour::actors {
namespace {

std::string numbered(std::size_t number) {
  return "secret " + std::to_string(number) + ".";
}

void add_many(RecentSecrets& recent, std::size_t from, std::size_t to) {
  for (; from < to; ++from)
    recent.add(numbered(from));
}

TEST(RecentSecrets, KnowsATextAsItIsAndMasksItAnyhow) {
  RecentSecrets recent;
  EXPECT_TRUE(recent.add(" One two"));
  EXPECT_FALSE(recent.add(" One two"));
  EXPECT_FALSE(recent.add("  "));
  EXPECT_TRUE(recent.contains(" One two"));
  EXPECT_FALSE(recent.contains("one two"));
  EXPECT_EQ(recent.secrets().masked("so one two"), "so ***");
}

TEST(RecentSecrets, ForgetsTheOldest) {
  RecentSecrets recent;
  recent.add("zero"); // the last in the alphabet
  add_many(recent, 0, RecentSecrets::most);
  const std::string newest = "0"; // the first
  EXPECT_TRUE(recent.add(newest));
  EXPECT_TRUE(recent.contains(newest));
  EXPECT_TRUE(recent.contains(numbered(RecentSecrets::most - 1)));
  EXPECT_TRUE(recent.contains(numbered(RecentSecrets::most / 4 + 1)));
  EXPECT_FALSE(recent.contains("zero"));
  EXPECT_EQ(recent.secrets().masked("zero, 0"), "zero, ***");
}

TEST(RecentSecrets, KeepsWhatWasSaidAgain) {
  RecentSecrets recent;
  recent.add("zero");
  add_many(recent, 0, RecentSecrets::most / 2);
  recent.add("zero");
  add_many(recent, RecentSecrets::most / 2, RecentSecrets::most + 1);
  EXPECT_FALSE(recent.contains(numbered(0)));
  EXPECT_TRUE(recent.contains("zero"));
}

} // namespace
} // namespace parlour::actors
