#include <gtest/gtest.h>

#include "adapters/asr/words/phones.hpp"

namespace parlour::adapters::asr {
namespace {

TEST(PhonesTest, FollowEspeaksPhonemes) {
  EXPECT_EQ(phones_of("dZ_'E_f_3_r_i"), "JH EH F ER R IY");
  EXPECT_EQ(phones_of("h_'oU"), "HH OW");
  EXPECT_EQ(phones_of("j_a# k_'V_n"), "Y AH K AH N");
  EXPECT_EQ(phones_of(",eI_t_,i:_;_'E_m"), "EY T IY EH M");
  EXPECT_EQ(phones_of("r_'a_f_@L_z"), "R AE F AH L Z");
  EXPECT_EQ(phones_of("b_'V_?_n-"), "B AH AH N");
}

TEST(PhonesTest, KnowWhatTheyDoNotKnow) {
  EXPECT_EQ(phones_of("X_y!"), std::nullopt);
  EXPECT_EQ(phones_of(""), std::nullopt);
  EXPECT_EQ(phones_of("'_,"), std::nullopt);
}

TEST(PhonesTest, TellThoseOfTheModel) {
  EXPECT_TRUE(are_phones("HH OW"));
  EXPECT_FALSE(are_phones("HH QQ"));
  EXPECT_FALSE(are_phones(""));
}

} // namespace
} // namespace parlour::adapters::asr
