#include <gtest/gtest.h>

#include "script/dialogue/frame/many_values.hpp"

namespace parlour::dialogue {
namespace {

Value item(const char* value, int amount) {
  return Map{{"value", value}, {"amount", amount}};
}

TEST(ManyValues, AreHeldWithTheirAmounts) {
  ManyValues values;
  values.put("tea", 2, false);
  values.put("cake", {}, false);
  EXPECT_EQ(values.take(), Value(List{item("tea", 2), item("cake", 1)}));
}

TEST(ManyValues, AreUnknownWhereThereAreNone) {
  EXPECT_TRUE(ManyValues(Value("tea")).empty());
  EXPECT_TRUE(ManyValues().take().is_unknown());
}

TEST(ManyValues, TakePlainValuesForOneOfEach) {
  EXPECT_EQ(ManyValues(Value(List{"tea"})).take(), Value(List{item("tea", 1)}));
}

TEST(ManyValues, GetAnotherAmountOrMore) {
  ManyValues values(Value(List{item("tea", 2)}));
  values.put("tea", {}, false); // said again
  EXPECT_TRUE(values.has("tea"));
  EXPECT_EQ(ManyValues(values).take(), Value(List{item("tea", 2)}));
  values.put("tea", 3, false);
  EXPECT_EQ(ManyValues(values).take(), Value(List{item("tea", 3)}));
  values.put("tea", {}, true);
  values.put("tea", 2, true);
  EXPECT_EQ(values.take(), Value(List{item("tea", 6)}));
}

TEST(ManyValues, HavePartsOfAnAmount) {
  ManyValues values(Value(List{item("pound", 1)}));
  values.put("pound", 0.5, true);
  EXPECT_EQ(values.take().at(0)["amount"], Value(1.5));
}

TEST(ManyValues, GoAndAreReplaced) {
  ManyValues values(Value(List{item("tea", 2), item("cake", 1)}));
  EXPECT_FALSE(values.remove("pie", {}));
  EXPECT_TRUE(values.remove("tea", {}));
  EXPECT_FALSE(values.has("tea"));
  values.replace_last("pie", 4);
  EXPECT_EQ(values.take(), Value(List{item("pie", 4)}));
}

TEST(ManyValues, AreFewer) {
  ManyValues values(Value(List{item("tea", 3), item("cake", 1)}));
  EXPECT_TRUE(values.remove("tea", 1));
  EXPECT_TRUE(values.remove("cake", 1));
  EXPECT_EQ(values.take(), Value(List{item("tea", 2)}));
  values = ManyValues(Value(List{item("tea", 3), item("cake", 1)}));
  EXPECT_TRUE(values.remove("tea", 4));
  EXPECT_EQ(values.take(), Value(List{item("cake", 1)}));
  values = ManyValues(Value(List{Map{{"value", "tea"}}})); // no amount: 1
  EXPECT_TRUE(values.remove("tea", 0.5));
  EXPECT_EQ(values.take().at(0)["amount"], Value(0.5));
}

} // namespace
} // namespace parlour::dialogue
