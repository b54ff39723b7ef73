#include <gtest/gtest.h>

#include "script/compiler/compiler.hpp"
#include "script/program/constant_text.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::script {
namespace {

std::optional<std::string_view> question(const std::string& text) {
  static std::shared_ptr<const Program> program; // what is given lives with it
  const test::TemporaryFolder folder;
  folder.write("x.xml", "<dialogue><topic name=\"T\"><slot name=\"S\" "
                        "question=\"" +
                            text + "\"/></topic></dialogue>");
  program = compile_file(folder.path() / "x.xml", {}).program;
  return constant_text(*program, program->topics[0].slots[0].question);
}

TEST(ConstantText, IsGivenWithoutBeingRun) {
  EXPECT_EQ(question("When?"), "When?");
}

TEST(ConstantText, IsNothingWhereItMustBeWorkedOut) {
  EXPECT_EQ(question("When, {this.S}?"), std::nullopt);
}

} // namespace
} // namespace parlour::script
