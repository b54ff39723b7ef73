#include <gtest/gtest.h>

#include "script/compiler/code/expressions/code_builder.hpp"

namespace parlour::script {

namespace {

TEST(CodeBuilder, ABlockEndsTheLifeOfItsNamesAndRegisters) {
  Program program;
  Names names;
  Findings findings;
  CodeBuilder builder(program, names, findings, {});
  builder.declare("a");
  builder.open_scope();
  const auto inner = builder.declare("a");
  EXPECT_EQ(builder.find("a").index, inner);
  builder.close_scope();
  EXPECT_EQ(builder.find("a").index, 0u);
  EXPECT_EQ(builder.declare("b"), inner);
}

TEST(CodeBuilder, KnowsTheNamesOfTheSystem) {
  EXPECT_EQ(message_parameter("_LPARAM1"), 0u);
  EXPECT_EQ(message_parameter("_LPARAM12_"), 11u);
  EXPECT_FALSE(message_parameter("_LPARAM0"));
  EXPECT_FALSE(message_parameter("_LPARAMS"));
  EXPECT_EQ(system_variable("_FrameDone"), SystemVariable::frame_done);
}

TEST(Source, PlacesCountCodePoints) {
  const Source source{"é\nxy", {0, 5, 3}};
  EXPECT_EQ(source.at(2), (Position{0, 5, 4}));
  EXPECT_EQ(source.at(4), (Position{0, 6, 2}));
}

} // namespace

} // namespace parlour::script
