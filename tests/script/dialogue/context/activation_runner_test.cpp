// Activations: slices, waits and errors, as a session sees them.
#include <gtest/gtest.h>

#include "script/dialogue/context/activation_runner.hpp"
#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

std::string on_ring(const std::string& statements) {
  return "<handler name='H'><messages><component><Bell><Rings>" + statements +
         "</Rings><Stops><speak param='Stopped.'/></Stops></Bell></component>"
         "</messages></handler><state name='A'/><state name='B'/>";
}

constexpr const char* long_loop =
    "<for name='i' from='1' to='20000'><var name='x' expr='i'/></for>";

TEST(ActivationRunner, ALongActivationYieldsAndEnds) {
  World world(on_ring(std::string(long_loop) + "<speak param='Counted.'/>"));
  const auto before = world.steps;
  world.event("Bell", "Rings");
  EXPECT_EQ(world.said(), Texts{"Counted."});
  EXPECT_GT(world.steps - before, 4u); // slices
}

TEST(ActivationRunner, WhatItAskedForWaitsForItsEndNotForASlice) {
  World world(on_ring("<transit state='A'/>" + std::string(long_loop) +
                      "<transit state='B'/><speak param='In {_STATE}.'/>"));
  world.event("Bell", "Rings");
  EXPECT_EQ(world.said(), Texts{"In unknown."});
  EXPECT_EQ(world.conversation->state(), "B");
  EXPECT_EQ(world.seen(InspectionKind::transition).size(), 1u);
}

TEST(ActivationRunner, AnEndlessLoopIsStopped) {
  World world(on_ring("<while cond='true'/>"));
  world.event("Bell", "Rings");
  EXPECT_EQ(world.said().size(), 1u); // unavailable
  ASSERT_EQ(world.seen(InspectionKind::error).size(), 1u);
  EXPECT_EQ(world.seen(InspectionKind::error)[0].rfind("Limit: ", 0), 0u);
  world.event("Bell", "Stops");
  EXPECT_EQ(world.said(), Texts{"Stopped."});
}

TEST(ActivationRunner, ErrorsTellWhere) {
  World world("<function name='f'><throw expr=\"'bad'\"/></function>" +
              on_ring("<call function='f'/>"));
  world.event("Bell", "Rings");
  const auto errors = world.seen(InspectionKind::error);
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_NE(errors[0].find("test.xml:1: bad"), std::string::npos) << errors[0];
  EXPECT_NE(errors[0].find("in function f"), std::string::npos) << errors[0];
}

} // namespace
} // namespace parlour::dialogue
