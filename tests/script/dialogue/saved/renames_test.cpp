#include <gtest/gtest.h>

#include "script/dialogue/saved/renames.hpp"

namespace parlour::dialogue {
namespace {

std::shared_ptr<script::Program> program() {
  auto made = std::make_shared<script::Program>();
  made->topics.resize(2);
  made->topics[0].name = "Taxi";
  made->topics[0].slots.resize(2);
  made->topics[0].slots[0].name = "Where";
  made->topics[0].slots[1].name = "When";
  made->topics[1].name = "Shops";
  made->states.resize(1);
  made->states[0].name = "Welcome";
  made->variables.resize(2);
  made->variables[0].name = "count";
  made->variables[1].name = "limit";
  made->variables[1].is_constant = true;
  made->code.resize(3);
  made->code[0].name = "function f";
  made->code[1].name = "timer 'knock' in function f";
  made->code[2].name = "timer 'knock' in function f";
  return made;
}

TEST(Renames, FindsWhatHasTheSameName) {
  const auto to = program();
  std::swap(to->topics[0], to->topics[1]);
  std::swap(to->topics[1].slots[0], to->topics[1].slots[1]);
  const Renames renames(program(), to);
  EXPECT_EQ(renames.topic(0), 1u);
  EXPECT_EQ(renames.slot(0, 0), 1u);
  EXPECT_EQ(renames.state(0), 0u);
  EXPECT_EQ(renames.variable(0), 0u);
  EXPECT_EQ(renames.code(2), 2u);
}

TEST(Renames, WhatIsNotThereHasNoId) {
  const auto to = program();
  to->topics.resize(1);
  to->topics[0].slots[0].name = "Whither";
  to->states[0].name = "Hello";
  const Renames renames(program(), to);
  EXPECT_EQ(renames.topic(1), script::no_id);
  EXPECT_EQ(renames.topic(script::no_id), script::no_id);
  EXPECT_EQ(renames.slot(0, 0), script::no_id);
  EXPECT_EQ(renames.slot(1, 0), script::no_id);
  EXPECT_EQ(renames.state(0), script::no_id);
}

TEST(Renames, AConstantKeepsNoValue) {
  EXPECT_EQ(Renames(program(), program()).variable(1), script::no_id);
}

TEST(Renames, ATimerIsFoundInAnotherPlace) {
  const auto to = program();
  to->code[1].name = "timer 'knock' in function g";
  to->code[2].name = "function g";
  const Renames renames(program(), to);
  EXPECT_EQ(renames.code(1), 1u);
  EXPECT_EQ(renames.code(2), 1u);
}

TEST(Renames, ABodyTakesTheSameArguments) {
  const auto to = program();
  to->code[1].parameter_names = {"who"};
  EXPECT_EQ(Renames(program(), to).code(1), script::no_code);
}

} // namespace
} // namespace parlour::dialogue
