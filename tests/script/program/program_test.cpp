#include <gtest/gtest.h>

#include "script/program/program.hpp"

namespace parlour::script {

TEST(Program, finds_by_name) {
  Program program;
  program.topics.resize(2);
  program.topics[1].name = "Taxi";
  program.topics[1].slots.resize(1);
  program.topics[1].slots[0].name = "Time";
  program.states.resize(1);
  program.states[0].name = "Busy";
  EXPECT_EQ(program.topic("Taxi"), 1u);
  EXPECT_EQ(program.topic("taxi"), no_id);
  EXPECT_EQ(program.topics[1].slot("Time"), 0u);
  EXPECT_EQ(program.topics[1].slot("rows"), no_id);
  EXPECT_EQ(program.state("Busy"), 0u);
  EXPECT_EQ(program.state("Wait"), no_id);
}

TEST(Program, tells_places) {
  Program program;
  program.files = {"a.xml"};
  EXPECT_EQ(program.place({0, 2, 3}), (SourceLocation{"a.xml", 2, 3}));
  EXPECT_EQ(program.place({7, 2, 3}), (SourceLocation{"", 2, 3}));
}

} // namespace parlour::script
