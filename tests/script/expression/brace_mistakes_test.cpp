#include <gtest/gtest.h>

#include "script/expression/brace_mistakes.hpp"

namespace parlour::script {

namespace {

const KnownNames known{[](const auto& name) { return name == "seats"; },
                       [](const auto& name) { return name == "free"; }};

std::string said(std::string_view text, bool is_heard = true) {
  const auto mistake = explain_brace(text, 0, known, is_heard);
  return mistake ? std::to_string(mistake->length) + ": " + mistake->message
                 : "";
}

} // namespace

TEST(BraceMistakes, are_those_of_the_expression_inside) {
  EXPECT_EQ(said("{typeof seats} left"),
            "14: there is no 'typeof' here; write type(x)");
  EXPECT_EQ(said("{(seats}"), "8: this '(' is not closed; ')' is missing");
  EXPECT_EQ(said("{free(1 2)}"), "11: ',' or ')' is missing before '2'");
}

TEST(BraceMistakes, tell_of_a_variable_where_words_stand_behind_it) {
  EXPECT_EQ(said("{seats left}"), "12: for the variable write {seats}");
  EXPECT_EQ(said("{seats left"), "1: for the variable write {seats}");
}

TEST(BraceMistakes, reach_behind_the_braces_inside) {
  EXPECT_EQ(said("{'{}'.format(seats)} {b}"),
            "20: a function stands before what it works on: format('{}', "
            "seats)");
}

TEST(BraceMistakes, are_none_where_text_stands_in_braces) {
  for (const auto* text : {"{so on}", "{the seats}", "{smiles, then waves}",
                           "{=== so ===}", "{:)}", "{}", "{2,3}"})
    EXPECT_EQ(said(text), "") << text;
}

TEST(BraceMistakes, are_corrected_where_that_is_sure) {
  const auto mended = [](std::string_view text) {
    return explain_brace(text, 0, known, true)->replacement.value_or("");
  };
  EXPECT_EQ(mended("{seats === 1}"), "{seats == 1}");
  EXPECT_EQ(mended("{NOT seats}"), "{not seats}");
  for (const auto* text : {"{typeof seats}", "{seats left}", "{seats is late}",
                           "{seats.get('a')}"})
    EXPECT_EQ(mended(text), "") << text;
}

TEST(BraceMistakes, take_a_path_as_a_whole) {
  EXPECT_EQ(said("{seats.left now}"),
            "16: for the variable write {seats.left}");
  EXPECT_EQ(said("{seats.left if seats.left}"),
            "26: there is no 'if' here; a choice is written condition ? value "
            ": otherwise");
}

TEST(BraceMistakes, leave_other_languages_alone_where_nobody_hears_them) {
  EXPECT_EQ(said("{ margin: 0; padding: seats }", false), "");
  EXPECT_EQ(said("{typeof seats}", false),
            "14: there is no 'typeof' here; write type(x)");
}

TEST(BraceMistakes, look_like_computing_where_it_can_be_heard_only) {
  EXPECT_EQ(said("{1 = 2}"), "7: '=' does not compare; write '=='");
  EXPECT_EQ(said("{1 = 2}", false), "");
}

} // namespace parlour::script
