#include <gtest/gtest.h>

#include "script/vm/program_identity.hpp"
#include "tests/script/snippets.hpp"

namespace parlour::script {

namespace {

std::uint64_t identity(const std::string& declarations) {
  return identity_of(*test::compile_declarations(declarations).program);
}

TEST(ProgramIdentity, IsOfTheContentWhereverItLies) {
  const auto script = "<function name='main'><print param='a'/></function>";
  EXPECT_EQ(identity(script), identity(script));
}

TEST(ProgramIdentity, ChangesWithEveryPart) {
  const auto one = identity("<var name='a'/><function name='main'/>");
  EXPECT_NE(one, identity("<var name='b'/><function name='main'/>"));
  EXPECT_NE(one, identity("<var name='a' expr='1'/><function name='main'/>"));
  EXPECT_NE(one, identity("<var name='a'/>\n<function name='main'/>"));
  EXPECT_NE(one, identity("<var name='a'/><function name='main'/>"
                          "<topic name='T'><slot name='S'/></topic>"));
}

} // namespace

} // namespace parlour::script
