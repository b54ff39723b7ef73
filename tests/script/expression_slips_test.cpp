#include <ostream>

#include <gtest/gtest.h>

#include "script/expression_slips.hpp"

namespace parlour::script {

namespace {

struct Wrong {
  const char* text;
  const char* said; // "offset: message" of each, a line each
  const char* mended = nullptr;
};

void PrintTo(const Wrong& wrong, std::ostream* stream) {
  *stream << wrong.text;
}

} // namespace

class ExpressionSlips : public testing::TestWithParam<Wrong> {};

TEST_P(ExpressionSlips, say_what_to_write_instead) {
  const std::string text = GetParam().text;
  const auto parsed = parse_expression(text);
  ASSERT_FALSE(parsed.node);
  const auto slips = find_slips(text, parsed);
  std::string said;
  for (const auto& slip : slips)
    said += std::to_string(slip.offset) + ": " + slip.message + '\n';
  EXPECT_EQ(said, GetParam().said);
  auto mended = text;
  for (auto slip = slips.rbegin(); slip != slips.rend(); ++slip)
    if (slip->replacement)
      mended.replace(slip->offset, slip->length, *slip->replacement);
  EXPECT_EQ(mended, GetParam().mended ? GetParam().mended : text);
  if (GetParam().mended) {
    EXPECT_TRUE(parse_expression(mended).node) << mended;
  }
}

INSTANTIATE_TEST_SUITE_P(
    signs, ExpressionSlips,
    testing::Values(
        Wrong{"a = 1", "2: '=' does not compare; write '=='\n", "a == 1"},
        Wrong{"a === 1", "2: '===' is written '=='\n", "a == 1"},
        Wrong{"a !== 1", "2: '!==' is written '!='\n", "a != 1"},
        Wrong{"a <> 1", "2: '<>' is written '!='\n", "a != 1"},
        Wrong{"a => 1", "2: '=>' is written '>='\n", "a >= 1"},
        Wrong{"a = 1 and b = 2",
              "2: '=' does not compare; write '=='\n"
              "12: '=' does not compare; write '=='\n",
              "a == 1 and b == 2"},
        Wrong{"=a", "0: an expression begins without '='; leave it out\n", "a"},
        Wrong{"a + 1;", "5: nothing ends with ';' here; leave it out\n",
              "a + 1"},
        Wrong{"n += 2", "2: an expression changes nothing; write <set "
                        "name=\"n\" expr=\"n + 2\"/>\n"},
        Wrong{"n++", "1: an expression changes nothing; write <set "
                     "name=\"n\" expr=\"n + 1\"/>\n"},
        Wrong{"a & b",
              "2: a single '&' has no meaning here; write 'and', or "
              "+ to join texts\n",
              "a and b"},
        Wrong{"1,5", "0: a fraction is written with a point: 1.5\n", "1.5"},
        Wrong{"2 * .5", "4: a fraction has a digit before its point: 0.5\n",
              "2 * 0.5"},
        Wrong{"a->b", "1: '->' is written as a point: map.field\n", "a.b"}));

INSTANTIATE_TEST_SUITE_P(
    texts, ExpressionSlips,
    testing::Values(
        Wrong{"Hello World",
              "0: this reads like text, and an expression is expected; a text "
              "stands in quotes: 'Hello World'\n",
              "'Hello World'"},
        Wrong{"It's nine o'clock",
              "0: this reads like text, and an expression is expected; a text "
              "stands in quotes: 'It\\'s nine o\\'clock'\n",
              "'It\\'s nine o\\'clock'"},
        Wrong{"", "0: an expression is expected and the value is empty; an "
                  "empty text is written ''\n"},
        Wrong{"“Hello”",
              "0: this is a typographic quotation mark; a text stands in "
              "straight ones: 'text'\n",
              "'Hello'"},
        Wrong{"'it's'",
              "3: this apostrophe ends the text; inside of quotes "
              "it is written \\'\n",
              "'it\\'s'"},
        Wrong{"'Hello", "0: the text that begins here has no closing quote; "
                        "expected another '\n"},
        Wrong{"'a' 'b'", "4: an operator is missing before this; + joins "
                         "texts\n"},
        Wrong{"2$", "1: '$' has no meaning here\n"},
        Wrong{"$name + 1",
              "0: in an expression a variable is its name alone: name\n",
              "name + 1"},
        Wrong{"{name}",
              "0: in an expression a variable is its name alone: name\n",
              "name"}));

INSTANTIATE_TEST_SUITE_P(
    words, ExpressionSlips,
    testing::Values(
        Wrong{"a AND b", "2: 'AND' is written 'and'\n", "a and b"},
        Wrong{"a is 1", "2: 'is' is written '=='\n", "a == 1"},
        Wrong{"a is not 1", "2: 'is not' is written '!='\n", "a != 1"},
        Wrong{"a AND NOT b",
              "2: 'AND' is written 'and'\n6: 'NOT' is written 'not'\n",
              "a and not b"},
        Wrong{"a ==", "2: a value is missing behind '=='\n"},
        Wrong{"a like 'b'", "2: there is no 'like' here; write matches(text, "
                            "'pattern')\n"},
        Wrong{"name.length() > 3",
              "0: a function stands before what it works on: length(name)\n",
              "length(name) > 3"},
        Wrong{"list.push(3)",
              "0: a function stands before what it works on: append(list, "
              "…)\n"},
        Wrong{"10min", "0: '10min' is neither a number nor a name, which "
                       "begins with a letter; a text stands in quotes: "
                       "'10min'\n"},
        Wrong{"a == b c", "7: an operator such as + or and is missing before "
                          "'c', or quotes around a text\n"}));

INSTANTIATE_TEST_SUITE_P(
    brackets, ExpressionSlips,
    testing::Values(
        Wrong{"length(a", "6: this '(' is not closed; ')' is missing\n"},
        Wrong{"(a + 1", "0: this '(' is not closed; ')' is missing\n"},
        Wrong{"f(a b)", "4: ',' or ')' is missing before 'b'\n"},
        Wrong{"a + 1)", "5: this ')' closes nothing\n"},
        Wrong{"a +", "2: a value is missing behind '+'\n"},
        Wrong{"(a +)", "4: a value is missing before this ')'\n"},
        Wrong{"1 lt 2 lt 3",
              "7: comparisons do not chain; join them with 'and'\n"}));

TEST(QuotedText, escapes_quotes_and_backslashes) {
  EXPECT_EQ(quoted_text("it's \\"), "'it\\'s \\\\'");
}

} // namespace parlour::script
