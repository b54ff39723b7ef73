#include <gtest/gtest.h>

#include "adapters/nlu/text/name_sounds.hpp"
#include "adapters/nlu/text/phones.hpp"

namespace parlour::adapters::nlu {
namespace {

using Words = std::vector<std::string>;

// Of what is heard as these words, or as one.
std::size_t unlike(const Words& heard, const Words& name) {
  return words_unlike(sounds_of_name(heard).phones, name, 0.7);
}

TEST(NameSounds, AreThoseOfAllItsWords) {
  EXPECT_EQ(sounds_of_name({"anand", "s", "o", "nair"}).phones,
            sounds_of_name({"anand", "son", "of", "nair"}).phones);
  EXPECT_EQ(sounds_of_name({"devi", "d", "o", "nair"}).phones,
            sounds_of_name({"devi", "daughter", "of", "nair"}).phones);
  const auto made = sounds_of_name({"quek", "xiu"});
  EXPECT_EQ(made.phones, "kwekSiu");
  EXPECT_EQ(made.kinds, sounds_in("kwekSiu"));
  EXPECT_TRUE(sounds_of_name({}).phones.empty());
}

TEST(NameSounds, WordsThatJoinNamesAreTitlesAndLightWords) {
  for (const auto* const word : {"bin", "s", "dr"})
    EXPECT_TRUE(joins_names(word)) << word;
  EXPECT_FALSE(joins_names("anand"));
}

TEST(NameSounds, AreHeardInWordsThatAreDividedOtherwise) {
  EXPECT_EQ(
      unlike({"vijson", "of", "chandran"}, {"vijay", "s", "o", "chandran"}),
      0U);
  EXPECT_EQ(unlike({"russnebinti", "ismail"}, {"rosnah", "binti", "ismail"}),
            0U);
  EXPECT_EQ(unlike({"cosokwee"}, {"koh", "sok", "hwee"}), 0U);
}

TEST(NameSounds, CountWordsThatSoundOtherwise) {
  EXPECT_EQ(unlike({"jeffery", "palmer"}, {"jeffery", "ho"}), 1U);
  EXPECT_EQ(unlike({"ai", "ling"}, {"phua", "ai", "ling"}), 1U);
  EXPECT_EQ(unlike({"smith"}, {"goh", "xin", "yi"}), 3U);
}

TEST(NameSounds, WithoutSoundsAreUnlikeAll) {
  EXPECT_EQ(unlike({}, {"goh", "xin", "yi"}), 3U);
  EXPECT_EQ(unlike({}, {}), 0U);
}

} // namespace
} // namespace parlour::adapters::nlu
