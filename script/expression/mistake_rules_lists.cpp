// Matching of brackets and strings, and rules about what other languages write
// in brackets.
#include <algorithm>
#include <vector>

#include "script/expression/mistake_rules.hpp"

namespace parlour::script::mistake_rules {

namespace {

// Calls visit(i) for each byte in [begin, end) outside of strings until it
// returns true; returns that offset, or npos.
template <class Visit>
std::size_t find_outside_quotes(std::string_view text, std::size_t begin,
                                std::size_t end, Visit visit) {
  char quote = 0;
  for (auto i = begin; i < std::min(end, text.size()); ++i) {
    const char c = text[i];
    if (quote)
      quote = c == quote && text[i - 1] != '\\' ? '\0' : quote;
    else if (c == '\'' || c == '"')
      quote = c;
    else if (visit(i))
      return i;
  }
  return npos;
}

// Round, square and curly brackets are treated alike.
bool opens(char c) {
  return std::string_view("([{").find(c) != npos;
}

bool closes(char c) {
  return std::string_view(")]}").find(c) != npos;
}

} // namespace

std::size_t open_bracket(std::string_view text, std::size_t end) {
  std::vector<std::size_t> open;
  find_outside_quotes(text, 0, end, [&](std::size_t i) {
    if (opens(text[i]))
      open.push_back(i);
    else if (closes(text[i]) && !open.empty())
      open.pop_back();
    return false;
  });
  return open.empty() ? npos : open.back();
}

// Counts the depth of all kinds of brackets together.
std::size_t closing_of(std::string_view text, std::size_t open) {
  int depth = 0;
  return find_outside_quotes(text, open, text.size(), [&](std::size_t i) {
    depth += opens(text[i]) ? 1 : closes(text[i]) ? -1 : 0;
    return depth == 0;
  });
}

// Scans from the beginning, because whether a quote opens or closes a string
// cannot be told from behind.
std::size_t opening_of(std::string_view text, std::size_t close) {
  std::vector<std::size_t> open;
  std::size_t quote = npos; // start of the string around
  for (std::size_t i = 0; i <= close && i < text.size(); ++i) {
    const char c = text[i];
    const bool ends = quote != npos && c == text[quote] && text[i - 1] != '\\';
    if (ends && i == close)
      return quote;
    if (quote != npos)
      quote = ends ? npos : quote;
    else if (c == '\'' || c == '"')
      quote = i;
    else if (opens(c))
      open.push_back(i);
    else if (closes(c) && !open.empty() && i == close)
      return open.back();
    else if (closes(c) && !open.empty())
      open.pop_back();
  }
  return npos;
}

// Steps back over f(a)[0] and (a + b)[i] bracket by bracket.
std::size_t operand_begin(std::string_view text, std::size_t end) {
  if (end == 0)
    return end;
  const char last = text[end - 1];
  if (!closes(last) && last != '\'' && last != '"')
    return path_begin(text, end);
  const auto open = opening_of(text, end - 1);
  if (open == npos || !closes(last) || last == '}')
    return open == npos ? end : open;
  const bool goes_on = open > 0 && closes(text[open - 1]); // f(a)[0]
  return goes_on ? operand_begin(text, open) : path_begin(text, open);
}

// Commas inside of brackets and strings do not separate.
std::vector<std::string_view> split_arguments(std::string_view text) {
  std::vector<std::string_view> all;
  if (trimmed(text).empty())
    return all;
  std::size_t begin = 0;
  int depth = 0;
  find_outside_quotes(text, 0, text.size(), [&](std::size_t i) {
    depth += opens(text[i]) ? 1 : closes(text[i]) ? -1 : 0;
    if (text[i] == ',' && depth == 0) {
      all.push_back(trimmed(text.substr(begin, i - begin)));
      begin = i + 1;
    }
    return false;
  });
  all.push_back(trimmed(text.substr(begin)));
  return all;
}

// Explains list[1, 2], the index of a matrix.
Found comma_in_index(const Scene& scene) {
  if (!scene.rest().starts_with(','))
    return {};
  const auto open = open_bracket(scene.text, scene.at);
  const auto close = open == npos ? npos : closing_of(scene.text, open);
  if (close == npos || scene.text[open] != '[' ||
      operand_begin(scene.text, open) == open)
    return {};
  std::string meant;
  for (const auto part :
       split_arguments(scene.text.substr(open + 1, close - open - 1)))
    meant += "[" + string_of(part) + "]";
  const auto begin = operand_begin(scene.text, open);
  return ExpressionMistake{
      open, close + 1 - open,
      "a list of lists is read by one position after the "
      "other: " +
          string_of(scene.text.substr(begin, open - begin)) + meant,
      meant};
}

// Explains (1, 2) where a list is meant.
Found round_list(const Scene& scene) {
  if (!scene.rest().starts_with(','))
    return {};
  const auto open = open_bracket(scene.text, scene.at);
  if (open == npos || scene.text[open] != '(')
    return {};
  const auto close = closing_of(scene.text, open);
  if (close == npos)
    return {};
  const auto inside = scene.text.substr(open + 1, close - open - 1);
  const auto list = "[" + string_of(trimmed(inside)) + "]";
  ExpressionMistake mistake{open, close + 1 - open,
                            "a list stands in square brackets: " + list};
  if (parse_arguments(inside).node)
    mistake.replacement = list;
  return mistake;
}

// Explains a ? b without the other branch.
Found half_a_choice(const Scene& scene) {
  if (scene.fault != SyntaxFault::missing || scene.sign != ':' ||
      scene.text.find('?') == npos)
    return {};
  return ExpressionMistake{scene.text.find('?'), 1,
                           "a choice has two values: condition ? value : "
                           "otherwise"};
}

// Explains list[1:3], a slice of Python.
Found slice_of_list(const Scene& scene) {
  if (!scene.rest().starts_with(':'))
    return {};
  const auto open = open_bracket(scene.text, scene.at);
  if (open == npos || open == 0 || scene.text[open] != '[')
    return {};
  const auto close = closing_of(scene.text, open);
  // Only a name can be sliced; the brackets alone would be a list.
  const auto begin = path_begin(scene.text, open);
  if (close == npos || begin == open)
    return {};
  const auto from = trimmed(scene.text.substr(open + 1, scene.at - open - 1));
  const auto to =
      trimmed(scene.text.substr(scene.at + 1, close - scene.at - 1));
  const auto call = "slice(" +
                    string_of(scene.text.substr(begin, open - begin)) + ", " +
                    (from.empty() ? "0" : string_of(from)) +
                    (to.empty() ? "" : ", ") + string_of(to) + ")";
  ExpressionMistake mistake{begin, close + 1 - begin,
                            "a part of a list is given by: " + call};
  if (parse_expression(call).node)
    mistake.replacement = call;
  return mistake;
}

// Explains {price:.2f}, a format specification of Python.
Found layout_of_value(const Scene& scene) {
  const auto object = scene.before();
  if (!scene.rest().starts_with(':') || object.empty() ||
      open_bracket(scene.text, scene.at) != npos ||
      !parse_expression(object).node)
    return {};
  return ExpressionMistake{scene.at, scene.rest().size(),
                           "a value is laid out by format(), such as format("
                           "'{:.2}', " +
                               string_of(object) + ")"};
}

} // namespace parlour::script::mistake_rules
