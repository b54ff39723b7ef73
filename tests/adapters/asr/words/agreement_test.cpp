#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/asr/words/agreement.hpp"

namespace parlour::adapters::asr {
namespace {

using testing::ElementsAre;

TEST(AgreementTest, IsThatOfTheWords) {
  const auto made =
      agreement({"a", "taxi", "to", "bedok"}, {"taxi", "two", "bedok"});
  EXPECT_DOUBLE_EQ(made.value, 0.5);
  EXPECT_THAT(made.agreed, ElementsAre(false, true, false, true));
  EXPECT_DOUBLE_EQ(agreement({"yes"}, {"yes"}).value, 1);
  EXPECT_DOUBLE_EQ(agreement({"yes"}, {"no"}).value, 0);
  EXPECT_DOUBLE_EQ(agreement({"yes"}, {"yes", "yes"}).value, 0.5);
  EXPECT_DOUBLE_EQ(agreement({}, {}).value, 0);
}

TEST(AgreementTest, CountsDifferences) {
  EXPECT_EQ(differences({"a", "b", "c"}, {"a", "c"}), 1u);
  EXPECT_EQ(differences({}, {"a", "c"}), 2u);
  EXPECT_EQ(differences({"x"}, {"y"}), 1u);
}

} // namespace
} // namespace parlour::adapters::asr
