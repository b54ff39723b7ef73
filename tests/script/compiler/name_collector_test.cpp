#include <gmock/gmock.h>

#include "script/compiler/name_collector.hpp"
#include "tests/script/snippets.hpp"

namespace parlour::script {

using testing::ElementsAre;
using testing::IsEmpty;

namespace {

struct Collection {
  Program program;
  Findings findings;
  Collected collected;
};

Collection collect(const std::string& application,
                   const std::string& library = "<dialogue/>") {
  Collection result;
  result.findings.add_file("a.xml");
  std::vector<Document> documents;
  documents.push_back({test::tree_of(library), true});
  documents.push_back({test::tree_of(application), false});
  result.collected = collect_names(documents, result.program, result.findings);
  return result;
}

} // namespace

TEST(NameCollector, prepares_what_is_declared) {
  const auto [program, findings, collected] =
      collect("<dialogue><var name='v'/><const name='c' private='true'/>"
              "<state name='s'/><handler name='h'/><topic name='t'>"
              "<slot name='A'/></topic></dialogue>");
  EXPECT_THAT(findings.all(), IsEmpty());
  ASSERT_EQ(program.variables.size(), 2u);
  EXPECT_TRUE(program.variables[1].is_constant);
  EXPECT_TRUE(program.variables[1].is_private);
  EXPECT_EQ(collected.names.variables.at("c"), 1u);
  EXPECT_EQ(program.states.at(0).name, "s");
  EXPECT_EQ(program.handlers.at(0).name, "h");
  EXPECT_EQ(program.topics.at(0).slots.at(0).name, "A");
}

TEST(NameCollector, notes_signatures) {
  const auto result =
      collect("<dialogue><functions><function name='f'><param name='a'/>"
              "<param name='b' expr='1'/></function></functions></dialogue>");
  const auto& function = result.collected.names.functions.at("f");
  EXPECT_EQ(function.required, 1u);
  EXPECT_EQ(function.parameters, 2u);
  EXPECT_THAT(function.parameter_names, ElementsAre("a", "b"));
  EXPECT_LT(function.code, result.program.code.size());
}

TEST(NameCollector, lets_an_application_override_a_library_s_function) {
  const auto result = collect("<dialogue>\n<function name='f'/></dialogue>",
                              "<dialogue><function name='f'/></dialogue>");
  EXPECT_THAT(result.findings.all(), IsEmpty());
  EXPECT_EQ(result.collected.names.functions.at("f").position.line, 2u);
  EXPECT_EQ(result.collected.functions[0].at("f").position.line, 1u);
}

} // namespace parlour::script
