#include <gtest/gtest.h>

#include "actors/support/privacy/shared_secrets.hpp"

namespace parlour::actors {
namespace {

TEST(SharedSecretsTest, MasksTheTextsOfAll) {
  SharedSecrets secrets;
  EXPECT_EQ(secrets.masked("nothing is private"), "nothing is private");
  secrets.add("91234567");
  secrets.add(" Ann Lee ");
  secrets.add("7b");
  EXPECT_EQ(secrets.masked("ANN LEE has 9123 4567, in 7B"),
            "*** has ***, in ***");
  EXPECT_EQ(secrets.masked("9-123-4567."), "***.");
  EXPECT_EQ(secrets.masked("17b, Ann, 9123456"), "17b, Ann, 9123456");
}

// As in the texts of a session, one that contains another is found first.
TEST(SharedSecretsTest, MasksTheLongerOne) {
  SharedSecrets secrets;
  secrets.add("12345");
  secrets.add("123456789");
  secrets.add("12345678-10");
  EXPECT_EQ(secrets.masked("it is 123456789"), "it is ***");
  EXPECT_EQ(secrets.masked("12345678-10"), "***");
}

TEST(SharedSecretsTest, FindsWhatHasNoLetters) {
  SharedSecrets secrets;
  secrets.add("...");
  secrets.add("-5");
  secrets.add("9-");
  EXPECT_EQ(secrets.masked("well ... no"), "well *** no");
  EXPECT_EQ(secrets.masked("it is -5"), "it is ***");
  EXPECT_EQ(secrets.masked("a 9- b"), "a *** b");
}

TEST(SharedSecretsTest, KnowsATextUntilAllHaveRemovedIt) {
  SharedSecrets secrets;
  secrets.add("Ann Lee");
  secrets.add("Ann Lee ");
  secrets.add("Ann Lennox");
  secrets.remove("Ann Lee");
  EXPECT_EQ(secrets.masked("Ann Lee"), "***");
  secrets.remove("Ann Lee");
  EXPECT_EQ(secrets.masked("Ann Lee, Ann Lennox"), "Ann Lee, ***");
  secrets.remove("Ann Lennox");
  secrets.remove("Ann Lennox");
  EXPECT_EQ(secrets.masked("Ann Lee, Ann Lennox"), "Ann Lee, Ann Lennox");
}

TEST(SharedSecretsTest, IgnoresBlanks) {
  SharedSecrets secrets;
  secrets.add(" ");
  secrets.remove(" ");
  EXPECT_EQ(secrets.masked("a b"), "a b");
}

} // namespace
} // namespace parlour::actors
