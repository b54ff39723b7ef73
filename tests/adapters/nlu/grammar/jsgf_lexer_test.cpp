#include <cstring>

#include <gtest/gtest.h>

#include "adapters/nlu/grammar/jsgf_lexer.hpp"

namespace parlour::adapters::nlu::jsgf {
namespace {

// One letter for the kind, then the text: "w:is r:on s:;".
std::string scanned(const std::string& text) {
  std::vector<Error> errors;
  std::string made;
  for (const auto& lexeme : scan(text, {}, errors))
    if (lexeme.kind != LexemeKind::end)
      made += std::string(made.empty() ? "" : " ") +
              "wqrgtxs"[static_cast<std::size_t>(lexeme.kind)] + ":" +
              lexeme.text;
  EXPECT_TRUE(errors.empty()) << text;
  return made;
}

TEST(JsgfLexer, ScansEveryKind) {
  struct {
    const char* text;
    const char* expected;
  } const cases[] = {
      {"", ""},
      {"public <ask> = is;", "w:public r:ask s:= w:is s:;"},
      {"(a|b)* [c]+", "s:( w:a s:| w:b s:) s:* s:[ w:c s:] s:+"},
      {"@Facility.Name <@db:t.c>", "g:Facility.Name g:db:t.c"},
      {"\"so be it\" {Slot=a b}", "q:so be it t:Slot=a b"},
      {"/2.5/ a", "x:2.5 w:a"},
      {"#JSGF V1.0 UTF-8 en;\na", "w:a"},
      {"\xEF\xBB\xBF"
       "a",
       "w:a"},
      {"a // b\nc /* d\n e */ f", "w:a w:c w:f"},
      {"don't", "w:don't"},
  };
  for (const auto& [text, expected] : cases)
    EXPECT_EQ(scanned(text), expected) << text;
}

TEST(JsgfLexer, KnowsThePlaces) {
  std::vector<Error> errors;
  const auto lexemes = scan("a\n  <b>", {"x.jsgf", 10, 5}, errors);
  ASSERT_EQ(lexemes.size(), 3U);
  EXPECT_EQ(lexemes[0].place.line, 10U);
  EXPECT_EQ(lexemes[0].place.column, 5U);
  EXPECT_EQ(lexemes[1].place.line, 11U);
  EXPECT_EQ(lexemes[1].place.column, 3U);
  EXPECT_EQ(lexemes[1].place.file, "x.jsgf");
  EXPECT_EQ(lexemes[2].kind, LexemeKind::end);
}

TEST(JsgfLexer, SaysWhatDoesNotEnd) {
  struct {
    const char* text;
    const char* message;
  } const cases[] = {
      {"a <b", "'<' is not followed by '>'"},
      {"a {b", "'{' is not followed by '}'"},
      {"a \"b", "'\"' is not followed by '\"'"},
      {"a /2", "'/' is not followed by '/'"},
      {"a /* b", "a comment that begins here does not end"},
      {"a > b", "'>' is not expected here"},
  };
  for (const auto& [text, message] : cases) {
    std::vector<Error> errors;
    const auto lexemes = scan(text, {"", 3, 1}, errors);
    ASSERT_EQ(errors.size(), 1U) << text;
    EXPECT_EQ(errors[0].message, message);
    EXPECT_EQ(errors[0].place.line, 3U);
    EXPECT_EQ(errors[0].place.column, 3U) << text;
    EXPECT_EQ(lexemes.front().text, "a");
    EXPECT_EQ(lexemes.back().kind, LexemeKind::end);
    EXPECT_EQ(lexemes.back().place.column, std::strlen(text) + 1) << text;
  }
}

} // namespace
} // namespace parlour::adapters::nlu::jsgf
