// The rules by which an expression that is not well-formed is explained: each
// knows one slip (expression_slips.hpp). Used by no others.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "script/expression/expression_slips.hpp"

namespace parlour::script::slip_rules {

using Found = std::optional<ExpressionSlip>;

inline constexpr auto npos = std::string_view::npos;
inline constexpr std::string_view blanks = " \t\r\n";

bool is_word_byte(char c);
bool is_digit(char c);
// The end and the beginning of the word at a place; the place itself where
// there is none.
std::size_t word_end(std::string_view text, std::size_t at);
std::size_t word_begin(std::string_view text, std::size_t end);
std::string_view trimmed(std::string_view text);
std::string string_of(std::string_view text);
// The beginning of what `x.y` ends at `end`.
std::size_t path_begin(std::string_view text, std::size_t end);
// The bracket that is still open at `end`; npos where none is. What closes the
// one that stands at `open`; npos where nothing does.
std::size_t open_bracket(std::string_view text, std::size_t end);
std::size_t closing_of(std::string_view text, std::size_t open);
// What opens the bracket or the quoted text that ends at `close`; npos where
// nothing does.
std::size_t opening_of(std::string_view text, std::size_t close);
// The beginning of the name, text, list or call that ends at `end`.
std::size_t operand_begin(std::string_view text, std::size_t end);
// "a, f(b, c)" at its commas, without blanks around.
std::vector<std::string_view> split_arguments(std::string_view text);

// Whether nothing but several words and their punctuation stands there.
using VisitWord = std::function<void(std::string_view)>;
bool is_made_of_words(std::string_view text, const VisitWord& visit);
// A word that computes here or in other languages.
bool is_operator_word(std::string_view word);

// The expression and the place where the parser gave up.
struct Scene {
  std::string_view text;
  std::size_t at = 0;
  std::string_view error;
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

// -- of texts (slip_rules_texts.cpp)
Found whole_text(const Scene& scene);
Found smart_quotes(const Scene& scene);
Found apostrophe(const Scene& scene);
Found in_braces(const Scene& scene);
Found decorated_name(const Scene& scene);
Found text_with_letter(const Scene& scene);

// -- of signs (slip_rules_signs.cpp, slip_rules_lists.cpp)
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

// -- of what is called (slip_rules_calls.cpp)
Found method(const Scene& scene);
Found filter(const Scene& scene);

// -- of words and brackets (slip_rules_words.cpp)
Found not_in(const Scene& scene);
Found word_of_other_language(const Scene& scene);
Found word_before(const Scene& scene);
Found number_with_letters(const Scene& scene);
Found unclosed_bracket(const Scene& scene);
Found early_end(const Scene& scene);
Found closing_bracket(const Scene& scene);
Found missing_operator(const Scene& scene);

} // namespace parlour::script::slip_rules
