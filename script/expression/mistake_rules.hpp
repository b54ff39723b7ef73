// The rules that explain why an expression is not well-formed. Each function
// knows one mistake and returns nothing if it sees another. They get the text
// and the place where the parser gave up, and look at characters rather than
// tokens, because what other languages write often has no tokens here. Internal
// to this folder; expression_mistakes.cpp has their order.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "script/expression/expression_mistakes.hpp"

namespace parlour::script::mistake_rules {

using Found = std::optional<ExpressionMistake>;

inline constexpr auto npos = std::string_view::npos;
inline constexpr std::string_view blanks = " \t\r\n";

bool is_word_byte(char c);
bool is_digit(char c);
// The end and the beginning of the word at an offset; the offset itself if
// there is no word.
std::size_t word_end(std::string_view text, std::size_t at);
std::size_t word_begin(std::string_view text, std::size_t end);
std::string_view trimmed(std::string_view text);
std::string string_of(std::string_view text);
// The beginning of the path (a name with fields, x.y) that ends at `end`.
std::size_t path_begin(std::string_view text, std::size_t end);
// open_bracket: the innermost bracket that is still open at `end`. closing_of:
// the bracket that closes the one at `open`. npos if there is none. Brackets in
// strings do not count.
std::size_t open_bracket(std::string_view text, std::size_t end);
std::size_t closing_of(std::string_view text, std::size_t open);
// The beginning of the bracket or string that ends at `close`; npos if there is
// none.
std::size_t opening_of(std::string_view text, std::size_t close);
// The beginning of the operand that ends at `end`: a path, a string, a list or
// a call.
std::size_t operand_begin(std::string_view text, std::size_t end);
// Splits "a, f(b, c)" at its outer commas and trims the parts.
std::vector<std::string_view> split_arguments(std::string_view text);

// Whether the text consists of several words and punctuation only. Calls
// `visit` with each word.
using VisitWord = std::function<void(std::string_view)>;
bool is_made_of_words(std::string_view text, const VisitWord& visit);
// Whether the word is an operator here or in another language.
bool is_operator_word(std::string_view word);

// What a rule looks at: the expression and the place where the parser gave up.
struct Scene {
  std::string_view text;
  std::size_t at = 0;
  std::string_view error; // the parser's message
  SyntaxFault fault = SyntaxFault::none;
  char sign = '\0'; // see Parsed
  Wanted wanted = Wanted::value;
  IsDeclared is_declared{};

  std::string_view rest() const {
    return text.substr(at);
  }
  std::string_view before() const {
    return trimmed(text.substr(0, at));
  }
  char previous() const {
    return at > 0 ? text[at - 1] : '\0';
  }
};

// -- strings, and texts without quotes: mistake_rules_texts.cpp
//   whole_text        an empty value; hello world
//   smart_quotes      “text”
//   apostrophe        'it's'
//   in_braces         {count gt 2}
//   decorated_name    $name, ${name}, @name
//   text_with_letter  f'hello {name}'
Found whole_text(const Scene& scene);
Found smart_quotes(const Scene& scene);
Found apostrophe(const Scene& scene);
Found in_braces(const Scene& scene);
Found decorated_name(const Scene& scene);
Found text_with_letter(const Scene& scene);

// -- signs, lists and brackets of other languages
//   assignment        age++, total += 2
//   escape            '\d', '\u00e9'
//   foreign_sign      ===, <>, **, ->
//   equals            = 5, a = b
//   semicolon         a + b;
//   comma_in_index    list[1, 2]
//   decimal_comma     2,5
//   leading_point     .5
//   round_list        (1, 2)
//   half_a_choice     a ? b
//   slice_of_list     list[1:3]
//   layout_of_value   price:.2f
Found assignment(const Scene& scene);
Found escape(const Scene& scene);
Found foreign_sign(const Scene& scene);
Found equals(const Scene& scene);
Found semicolon(const Scene& scene);
Found comma_in_index(const Scene& scene);
Found decimal_comma(const Scene& scene);
Found leading_point(const Scene& scene);
Found round_list(const Scene& scene);
Found half_a_choice(const Scene& scene);
Found slice_of_list(const Scene& scene);
Found layout_of_value(const Scene& scene);

// -- methods and filters: mistake_rules_calls.cpp
//   method            text.length(), Math.max(x, y)
//   filter            name | upper
Found method(const Scene& scene);
Found filter(const Scene& scene);

// -- words, and brackets that do not match: mistake_rules_words.cpp
//   not_in                  x not in list
//   word_of_other_language  a mod b, a is not b
//   word_before             NOT a, typeof a
//   number_with_letters     5pm
//   unclosed_bracket        f(a
//   early_end               a +
//   closing_bracket         a)
//   missing_operator        a b
Found not_in(const Scene& scene);
Found word_of_other_language(const Scene& scene);
Found word_before(const Scene& scene);
Found number_with_letters(const Scene& scene);
Found unclosed_bracket(const Scene& scene);
Found early_end(const Scene& scene);
Found closing_bracket(const Scene& scene);
Found missing_operator(const Scene& scene);

} // namespace parlour::script::mistake_rules
