#include <gtest/gtest.h>

#include "script/dialogue/frame/frame_view.hpp"

namespace parlour::dialogue {
namespace {

TEST(FrameView, SlotsAndWhatAnEnquiryFound) {
  TopicFrame frame;
  frame.slots.resize(2);
  frame.slots[1].value = "food court";
  frame.rows = ResultSet{{"name"}, {"Food Chain"}};
  frame.asked = Map{{"Category", "food court"}};
  frame.relaxed = {"Location"};
  EXPECT_EQ(read_slot(frame, 0), Value());
  EXPECT_EQ(read_slot(frame, 1), "food court");
  EXPECT_EQ(read_slot(frame, 2), Value());
  EXPECT_EQ(read_slot(frame, script::slot_rows), frame.rows);
  EXPECT_EQ(read_slot(frame, script::slot_asked)["Category"], "food court");
  EXPECT_EQ(read_slot(frame, script::slot_relaxed), List{"Location"});
}

} // namespace
} // namespace parlour::dialogue
