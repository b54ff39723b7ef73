#include <gtest/gtest.h>

#include "adapters/nlu/grammar/jsgf.hpp"

namespace parlour::adapters::nlu::jsgf {
namespace {

// "line:column message" of the first error, or "".
std::string first_error(const std::string& text,
                        const SourceLocation& place = {}) {
  std::vector<Error> errors;
  parse({"g", text, place}, errors);
  if (errors.empty())
    return "";
  const auto& error = errors[0];
  return std::to_string(error.place.line) + ":" +
         std::to_string(error.place.column) + " " + error.message;
}

TEST(Jsgf, ReadsRules) {
  std::vector<Error> errors;
  const auto grammar = parse({"",
                              "#JSGF V1.0 UTF-8 en;\ngrammar desk;\n"
                              "// a comment\n"
                              "public <a> = /2/ (hello | [hi] there)+ "
                              "{act=greet} /* and */ | <b>*;\n"
                              "<b> = <@Facility.Name> {x} \"o'clock\";",
                              {}},
                             errors);
  ASSERT_TRUE(errors.empty()) << errors[0].message;
  EXPECT_EQ(grammar.name, "desk");
  ASSERT_EQ(grammar.rules.size(), 2U);
  EXPECT_TRUE(grammar.rules[0].is_public);
  EXPECT_FALSE(grammar.rules[1].is_public);
  const auto& body = grammar.rules[0].body;
  ASSERT_EQ(body.kind, NodeKind::alternatives);
  EXPECT_EQ(body.weights, (std::vector<double>{2, 1}));
  const auto& repeated = body.children[0].children[0];
  EXPECT_EQ(repeated.kind, NodeKind::plus);
  EXPECT_EQ(repeated.tags[0].name, "act");
  EXPECT_EQ(repeated.tags[0].value, "greet");
  const auto& second = grammar.rules[1].body;
  EXPECT_EQ(second.children[0].kind, NodeKind::reference);
  EXPECT_EQ(second.children[0].text, "Facility.Name");
  EXPECT_EQ(second.children[1].text, "oclock");
}

struct Wrong {
  const char* text;
  const char* error;
};

class Errors : public testing::TestWithParam<Wrong> {};

TEST_P(Errors, HaveAPlace) {
  EXPECT_EQ(first_error(GetParam().text), GetParam().error);
}

INSTANTIATE_TEST_SUITE_P(
    All, Errors,
    testing::Values(
        Wrong{"public <a> = b", "1:15 ';' is expected here, not the end of the "
                                "grammar"},
        Wrong{"\n  <a> = ;", "2:9 words are expected here, not ';'"},
        Wrong{"<a> = (b;", "1:9 ')' is expected here, not ';'"},
        Wrong{"<a> = [b);", "1:9 ']' is expected here, not ')'"},
        Wrong{"a = b;",
              "1:1 a rule's name such as <greeting> is expected here, not "
              "'a'"},
        Wrong{"<a = b;", "1:1 '<' is not followed by '>'"},
        Wrong{"<a> = /x/ b;", "1:7 'x' is no weight: a number above 0"},
        Wrong{"<a> = b {};", "1:9 a tag is {Slot}, {Slot=value}, {act=…} or "
                             "{topic=…}"},
        Wrong{"<a> = b; <a> = c;",
              "1:10 the rule <a> is there already, in line 1"},
        Wrong{"import <x.y>;",
              "1:1 import is not supported: write the rules into "
              "this grammar"},
        Wrong{"<a> = b /* c", "1:9 a comment that begins here does not end"}));

TEST(Jsgf, CountsFromThePlaceOfItsText) {
  EXPECT_EQ(first_error("<a> = ;", {"app.xml", 12, 30}).substr(0, 6), "12:36 ");
  EXPECT_EQ(first_error("\n<a> = ;", {"app.xml", 12, 30}).substr(0, 5),
            "13:7 ");
}

TEST(Jsgf, GoesOnAfterAnError) {
  std::vector<Error> errors;
  const auto grammar = parse({"g", "<a> = ; <b> = ]; <c> = d;", {}}, errors);
  EXPECT_EQ(errors.size(), 2U);
  EXPECT_EQ(grammar.rules.back().name, "c");
}

TEST(Jsgf, ALiteralIsABooleanANumberOrAText) {
  EXPECT_EQ(literal("true"), Value(true));
  EXPECT_EQ(literal("12"), Value(std::int64_t{12}));
  EXPECT_EQ(literal("swimming pool"), Value("swimming pool"));
}

TEST(Jsgf, IsNotOverwhelmedByGroups) {
  EXPECT_NE(first_error("<a> = " + std::string(100'000, '(')), "");
}

} // namespace
} // namespace parlour::adapters::nlu::jsgf
