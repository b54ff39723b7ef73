#include <gtest/gtest.h>

#include "adapters/mqtt/complaints.hpp"

namespace parlour::adapters::mqtt {
namespace {

TEST(Complaints, GetALineNowAndThen) {
  Complaints complaints;
  std::chrono::steady_clock::time_point now{};
  EXPECT_EQ(complaints.note(Complaint::state, "first", now), "first");
  EXPECT_EQ(complaints.note(Complaint::state, "second", now), std::nullopt);
  EXPECT_EQ(complaints.note(Complaint::size, "other", now), "other");
  now += Complaints::one_line_in - Milliseconds(1);
  EXPECT_EQ(complaints.note(Complaint::state, "third", now), std::nullopt);
  now += Milliseconds(1);
  EXPECT_EQ(complaints.note(Complaint::state, "fourth", now),
            "fourth (and 2 more)");
  EXPECT_EQ(complaints.count(Complaint::state), 4u);
  EXPECT_EQ(complaints.count(Complaint::size), 1u);
  EXPECT_EQ(complaints.count(Complaint::number), 0u);
}

} // namespace
} // namespace parlour::adapters::mqtt
