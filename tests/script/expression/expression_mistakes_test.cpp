#include <ostream>

#include <gtest/gtest.h>

#include "script/expression/expression_mistakes.hpp"

namespace parlour::script {

namespace {

struct Wrong {
  const char* text;
  const char* said; // "offset: message" of each, a line each
  const char* mended = nullptr;
  Wanted wanted = Wanted::value;
};

void PrintTo(const Wrong& wrong, std::ostream* stream) {
  *stream << wrong.text;
}

} // namespace

class ExpressionMistakes : public testing::TestWithParam<Wrong> {};

TEST_P(ExpressionMistakes, say_what_to_write_instead) {
  const std::string text = GetParam().text;
  const auto parsed = parse_expression(text);
  ASSERT_FALSE(parsed.node);
  const auto mistakes = find_mistakes(text, parsed, GetParam().wanted);
  std::string said;
  for (const auto& mistake : mistakes)
    said += std::to_string(mistake.offset) + ": " + mistake.message + '\n';
  EXPECT_EQ(said, GetParam().said);
  auto mended = text;
  for (auto mistake = mistakes.rbegin(); mistake != mistakes.rend(); ++mistake)
    if (mistake->replacement)
      mended.replace(mistake->offset, mistake->length, *mistake->replacement);
  EXPECT_EQ(mended, GetParam().mended ? GetParam().mended : text);
  if (GetParam().mended) {
    EXPECT_TRUE(parse_expression(mended).node) << mended;
  }
}

INSTANTIATE_TEST_SUITE_P(
    signs, ExpressionMistakes,
    testing::Values(
        Wrong{"a = 1", "2: '=' does not compare; write '=='\n", "a == 1",
              Wanted::condition},
        Wrong{"a = 1", "2: '=' assigns nothing here; write the value alone, 1, "
                       "or '==' to compare\n"},
        Wrong{"a = 1",
              "2: the value stands in expr: <set name=\"a\" expr=\"1\"/>\n",
              nullptr, Wanted::target},
        Wrong{"++n", "0: an expression changes nothing; write <set name=\"n\" "
                     "expr=\"n + 1\"/>\n"},
        Wrong{"n++ + 1", "1: an expression changes nothing; write <set "
                         "name=\"n\" expr=\"n + 1\"/>\n"},
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
        Wrong{"a & b", "2: a single '&' has no meaning here; write 'and'\n",
              "a and b"},
        Wrong{"a & 'b'", "2: texts are joined by '+'\n", "a + 'b'"},
        Wrong{"a | upper",
              "0: a function stands before what it works on: upper(a)\n",
              "upper(a)"},
        Wrong{"f(l, x => x)",
              "7: '=>' has no meaning in brackets: a function is declared by "
              "<function>, a map is {'key': value}\n"},
        Wrong{"a ?: b", "2: '?:' is written: isknown(a) ? a : b\n"},
        Wrong{"1,5", "0: a fraction is written with a point: 1.5\n", "1.5"},
        Wrong{"2 * .5", "4: a fraction has a digit before its point: 0.5\n",
              "2 * 0.5"},
        Wrong{"a->b", "1: '->' is written as a point: map.field\n", "a.b"}));

INSTANTIATE_TEST_SUITE_P(
    texts, ExpressionMistakes,
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
        Wrong{"'Don't' + a + 'isn't'",
              "4: this apostrophe ends the text; inside of quotes it is "
              "written \\'\n"
              "18: this apostrophe ends the text; inside of quotes it is "
              "written \\'\n",
              "'Don\\'t' + a + 'isn\\'t'"},
        Wrong{"'yes'or'no", "7: the text that begins here has no closing "
                            "quote; expected another '\n"},
        Wrong{"'\\d+'", "1: a backslash in a text is written twice: \\\\d\n",
              "'\\\\d+'"},
        Wrong{"'\\u00e9'",
              "1: a character's number stands in braces: \\u{00e9}\n",
              "'\\u{00e9}'"},
        Wrong{"the door stands open",
              "0: this reads like text, and a condition is expected, such as "
              "door == 'open'\n",
              nullptr, Wanted::condition},
        Wrong{"{a gt 1}",
              "0: an expression stands here without braces: a gt 1\n",
              "a gt 1"},
        Wrong{"{a = 1}",
              "0: an expression stands here without braces: a == 1\n", "a == 1",
              Wanted::condition},
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
    words, ExpressionMistakes,
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
              "3)\n",
              "append(list, 3)"},
        Wrong{
            "a.greeted(3)",
            "2: there is no function 'greeted' here; one of your own is called "
            "greeted(a, 3)\n"},
        Wrong{"a.count(3)",
              "2: there is no function 'count' here; length(list) counts all "
              "of it, a <for each=\"x\" in=\"list\"> what fits\n"},
        Wrong{"a.upper('b')",
              "2: a function stands before what it works on: upper(a, …)\n"},
        Wrong{"a.startsWith('b')",
              "0: a function stands before what it works on: startswith(a, "
              "'b')\n",
              "startswith(a, 'b')"},
        Wrong{"a.get('k')", "0: there is no 'get' here; write a['k']\n",
              "a['k']"},
        Wrong{"a.toFixed(2)",
              "0: a function stands before what it works on: "
              "format('{:.2}', a)\n",
              "format('{:.2}', a)"},
        Wrong{"a.toFixed(n)",
              "2: there is no function 'toFixed' here; write format('{:.2}', "
              "x)\n"},
        Wrong{"', '.join(a)",
              "0: a function stands before what it works on: join(a, ', ')\n",
              "join(a, ', ')"},
        Wrong{"f(a)[0].trim()",
              "0: a function stands before what it works on: "
              "trim(f(a)[0])\n",
              "trim(f(a)[0])"},
        Wrong{"f'{a} of {b or c}'",
              "0: a text has no letter before its quotes; it is joined by "
              "'+': '' + a + ' of ' + (b or c)\n",
              "'' + a + ' of ' + (b or c)"},
        Wrong{"a:d", "1: a value is laid out by format(), such as "
                     "format('{:.2}', a)\n"},
        Wrong{"Math.max(a, 3)", "0: a function stands by itself here: max(…)\n",
              "max(a, 3)"},
        Wrong{"JSON.stringify(a)",
              "0: a function stands by itself here: tojson(…)\n", "tojson(a)"},
        Wrong{"a not in b", "0: 'not' stands first: not a in …\n",
              "not a in b"},
        Wrong{"typeof a", "0: there is no 'typeof' here; write type(x)\n"},
        Wrong{"10min", "0: '10min' is neither a number nor a name, which "
                       "begins with a letter; a text stands in quotes: "
                       "'10min'\n"},
        Wrong{"a == b c", "7: an operator such as + or and is missing before "
                          "'c', or quotes around a text\n"}));

INSTANTIATE_TEST_SUITE_P(
    brackets, ExpressionMistakes,
    testing::Values(
        Wrong{"length(a", "6: this '(' is not closed; ')' is missing\n"},
        Wrong{"(a + 1", "0: this '(' is not closed; ')' is missing\n"},
        Wrong{"a in (1, 2)", "5: a list stands in square brackets: [1, 2]\n",
              "a in [1, 2]"},
        Wrong{"l[1:2]", "0: a part of a list is given by: slice(l, 1, 2)\n",
              "slice(l, 1, 2)"},
        Wrong{"l[0, f(1, 2)]",
              "1: a list of lists is read by one position after the other: "
              "l[0][f(1, 2)]\n",
              "l[0][f(1, 2)]"},
        Wrong{"l[:2]", "0: a part of a list is given by: slice(l, 0, 2)\n",
              "slice(l, 0, 2)"},
        Wrong{"a ? 1", "2: a choice has two values: condition ? value : "
                       "otherwise\n"},
        Wrong{"f(a b)", "4: ',' or ')' is missing before 'b'\n"},
        Wrong{"a + 1)", "5: this ')' closes nothing\n"},
        Wrong{"a +", "2: a value is missing behind '+'\n"},
        Wrong{"(a +)", "4: a value is missing before this ')'\n"},
        Wrong{"1 lt 2 lt 3",
              "7: comparisons do not chain; join them with 'and'\n"}));

// One that is not mended leaves no other sure.
TEST(FindMistakes, correct_all_or_nothing) {
  const std::string text = "a AND b + ";
  for (const auto& mistake : find_mistakes(text, parse_expression(text)))
    EXPECT_FALSE(mistake.replacement) << mistake.message;
}

TEST(FindMistakes, know_what_is_declared) {
  const auto said = [](const std::string& text) {
    const auto mistakes =
        find_mistakes(text, parse_expression(text), Wanted::value,
                      [](const std::string& name) { return name == "door"; });
    return mistakes.empty() ? "" : mistakes.front().message;
  };
  EXPECT_EQ(said("door is open"), "'is' is written '=='");
  EXPECT_EQ(said("this is open"),
            "this reads like text, and an expression is expected; a text "
            "stands in quotes: 'this is open'");
}

TEST(Mended, is_an_expression_or_nothing) {
  EXPECT_EQ(mended("a AND b"), "a and b");
  EXPECT_EQ(mended("a + b"), "a + b");
  EXPECT_FALSE(mended("a +"));
}

TEST(QuotedText, escapes_quotes_and_backslashes) {
  EXPECT_EQ(quoted_text("it's \\"), "'it\\'s \\\\'");
}

} // namespace parlour::script
