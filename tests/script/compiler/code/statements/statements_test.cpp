#include <gtest/gtest.h>

#include "script/compiler/code/statements/statements.hpp"
#include "tests/script/snippets.hpp"

namespace parlour::script {

namespace {

std::string finding(const std::string& declarations) {
  const auto lines = test::compile_declarations(declarations).lines;
  return lines.empty() ? "" : lines[0];
}

TEST(Statements, NamesAreCheckedUnlessTheyAreComputed) {
  const std::string state = "<state name='Wait'/>";
  EXPECT_NE(finding(state + "<function name='f'><push state='Wiat'/>"
                            "</function>")
                .find("there is no state 'Wiat', did you mean 'Wait'?"),
            std::string::npos);
  EXPECT_EQ(finding(state + "<function name='f'><var name='n' expr='1'/>"
                            "<push state='W{n}'/></function>"),
            "");
}

TEST(Statements, NoTransitInAnExit) {
  EXPECT_NE(finding("<state name='A'><Exit><transit state='A'/></Exit></state>")
                .find("cannot stand in an Exit"),
            std::string::npos);
}

TEST(Statements, AnUnknownSlotIsAnError) {
  EXPECT_NE(finding("<topic name='T'><slot name='Time'/><filled>"
                    "<print param='{this.Tiem}'/></filled></topic>")
                .find("did you mean 'Time'"),
            std::string::npos);
}

} // namespace

} // namespace parlour::script
