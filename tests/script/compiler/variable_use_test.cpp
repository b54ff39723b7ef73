#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/script/snippets.hpp"

namespace parlour::script {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::size_t> read_by(const std::string& topic) {
  const auto outcome = test::compile_declarations(
      "<topic name='T'><slot name='A'/>" + topic + R"xml(</topic>
      <var name="one" expr="1"/><var name="two" expr="2"/>
      <function name="both"><return expr="one + other(two)"/></function>
      <function name="other"><param name="x"/>
        <return expr="x gt 5 ? both() : x"/></function>
      <function name="named"><param name="f"/>
        <call function="{f}" return="r"/><return expr="r"/></function>)xml");
  return outcome.program->topics[0].read_variables;
}

TEST(VariableUse, IsOfTheTopicsOwnCode) {
  EXPECT_THAT(read_by("<constraint cond='this.A gt 1' message='no'/>"),
              IsEmpty());
  EXPECT_THAT(read_by("<constraint cond='this.A gt two' message='no'/>"),
              ElementsAre(1));
  EXPECT_THAT(read_by("<slot name='B' question='{one}?'/>"), IsEmpty());
}

// Of two functions that call each other, each is looked at once.
TEST(VariableUse, IsOfFunctionsThatItCalls) {
  EXPECT_THAT(read_by("<slot name='B' expr='both()'/>"), ElementsAre(0, 1));
  EXPECT_THAT(read_by("<slot name='B' expr='other(1)'/>"), ElementsAre(0, 1));
}

TEST(VariableUse, IsOfAllWhereANameIsComputed) {
  EXPECT_THAT(read_by("<slot name='B' expr='named(1)'/>"), ElementsAre(0, 1));
}

} // namespace
} // namespace parlour::script
