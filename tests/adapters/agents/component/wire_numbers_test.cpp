#include <gtest/gtest.h>

#include "adapters/agents/component/wire_numbers.hpp"

namespace parlour::adapters::agents {
namespace {

TEST(WireNumbers, NoTwoConversationsShareANumber) {
  WireNumbers numbers;
  const auto anns = numbers.number_for({"ann", 1});
  const auto bobs = numbers.number_for({"bob", 1});
  EXPECT_NE(anns, bobs);
  ASSERT_NE(numbers.find(anns), nullptr);
  EXPECT_EQ(numbers.find(anns)->session, "ann");
  EXPECT_EQ(numbers.find(bobs)->session, "bob");
  EXPECT_EQ(numbers.find(bobs)->correlation, 1u);
}

TEST(WireNumbers, AMessageMayHaveSeveralAnswers) {
  WireNumbers numbers;
  const auto number = numbers.number_for({"ann", 7});
  EXPECT_NE(numbers.find(number), nullptr);
  EXPECT_NE(numbers.find(number), nullptr);
  EXPECT_EQ(numbers.find(number + 1), nullptr);
}

TEST(WireNumbers, ForgetsTheOldestOfTooMany) {
  WireNumbers numbers;
  const auto first = numbers.number_for({"ann", 1});
  const auto second = numbers.number_for({"ann", 2});
  for (std::size_t i = 2; i <= WireNumbers::max_askers; ++i)
    numbers.number_for({"bob", i});
  EXPECT_EQ(numbers.find(first), nullptr);
  EXPECT_NE(numbers.find(second), nullptr);
}

} // namespace
} // namespace parlour::adapters::agents
