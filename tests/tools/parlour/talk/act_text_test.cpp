#include <gtest/gtest.h>

#include "tools/parlour/talk/act_text.hpp"

namespace parlour::tools {
namespace {

Value taxi() {
  return Map{{"act", "inform"},
             {"topic", "Taxi"},
             {"confidence", 0.95},
             {"slots", Map{{"Time", Map{{"value", "15:00"}}},
                           {"Bags", 2},
                           {"Place", Map{{"value", Value()},
                                         {"candidates", List{"A", "B"}}}}}}};
}

TEST(ActText, has_slots_with_values_or_candidates) {
  EXPECT_EQ(act_text(taxi()),
            "inform Taxi (0.95): Time = 15:00, Bags = 2, Place = [A, B]");
}

TEST(ActText, may_leave_out_how_certain_it_is) {
  EXPECT_EQ(act_text_without_confidence(taxi()),
            "inform Taxi: Time = 15:00, Bags = 2, Place = [A, B]");
}

TEST(ActText, may_be_an_act_alone) {
  EXPECT_EQ(act_text(Map{{"act", "thank"}}), "thank");
}

} // namespace
} // namespace parlour::tools
