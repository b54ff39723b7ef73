#include <gtest/gtest.h>

#include "adapters/nlu/text/sounds.hpp"

namespace parlour::adapters::nlu {
namespace {

TEST(Sounds, are_equal_for_names_that_sound_alike) {
  EXPECT_EQ(sound_of("jeffery"), sound_of("geoffrey"));
  EXPECT_EQ(sound_of("jeffery"), sound_of("jeffree"));
  EXPECT_EQ(sound_of("catherine"), sound_of("katherine"));
  EXPECT_EQ(sound_of("stephen"), sound_of("steven").replace(2, 1, "f"));
  EXPECT_EQ(sound_of("ho"), sound_of("hoh"));
  EXPECT_EQ(sound_of("low"), sound_of("loh"));
  EXPECT_EQ(sound_of("lim"), sound_of("ling"));
  EXPECT_EQ(sound_of("wrapper"), sound_of("rapper"));
}

TEST(Sounds, differ) {
  EXPECT_NE(sound_of("lee"), sound_of("lau"));
  EXPECT_NE(sound_of("cinema"), sound_of("singh"));
  EXPECT_NE(sound_of("tan"), sound_of("tom"));
  EXPECT_NE(sound_of("anna"), sound_of("nina"));
  EXPECT_NE(sound_of("help"), sound_of("cynthia"));
}

TEST(Sounds, are_those_of_plain_letters) {
  EXPECT_EQ(sound_of("b1"), "");
  EXPECT_EQ(sound_of("jos\xc3\xa9"), "");
  EXPECT_EQ(sound_of(""), "");
}

} // namespace
} // namespace parlour::adapters::nlu
