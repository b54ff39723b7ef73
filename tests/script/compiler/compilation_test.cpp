#include <gmock/gmock.h>

#include "script/compiler/compilation.hpp"
#include "tests/script/snippets.hpp"

namespace parlour::script {

using testing::ElementsAre;

TEST(Compilation, splits_lists_of_names) {
  EXPECT_THAT(split_names(" ASR, Keyword Spotter ,,x"),
              ElementsAre("ASR", "Keyword Spotter", "x"));
  EXPECT_THAT(split_names(""), testing::IsEmpty());
}

TEST(Compilation, compiles_what_lies_inside_of_a_declaration) {
  const auto root = test::tree_of(
      "<topic><help><value>a {1 + 1}</value><value expr='2'/></help>"
      "<filled><print param='x'/></filled></topic>");
  Program program;
  Findings findings;
  findings.add_file("a.xml");
  const Names names;
  BodyCompiler bodies(program, names, findings);
  Compilation compilation{program, names, findings, bodies, {}, {}};
  EXPECT_EQ(compile_values(root.child("help"), {}, compilation).size(), 2u);
  EXPECT_TRUE(compile_values(nullptr, {}, compilation).empty());
  EXPECT_NE(compile_child(root, "filled", {}, compilation), no_code);
  EXPECT_EQ(compile_child(root, "started", {}, compilation), no_code);
  EXPECT_THAT(test::lines_of(findings), testing::IsEmpty());
}

} // namespace parlour::script
