// Brackets, and what other languages put into them.
#include <algorithm>
#include <vector>

#include "script/expression/slip_rules.hpp"

namespace parlour::script::slip_rules {

namespace {

// Calls `visit(i)` for every byte before `end` that is in no quotes, until that
// is true.
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

std::size_t closing_of(std::string_view text, std::size_t open) {
  int depth = 0;
  return find_outside_quotes(text, open, text.size(), [&](std::size_t i) {
    depth += opens(text[i]) ? 1 : closes(text[i]) ? -1 : 0;
    return depth == 0;
  });
}

std::size_t opening_of(std::string_view text, std::size_t close) {
  std::vector<std::size_t> open;
  std::size_t quote = npos; // where the text that we are in begins
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

// list[1, 2]
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
  return ExpressionSlip{open, close + 1 - open,
                        "a list of lists is read by one position after the "
                        "other: " +
                            string_of(scene.text.substr(begin, open - begin)) +
                            meant,
                        meant};
}

// (1, 2), where a list is meant.
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
  ExpressionSlip slip{open, close + 1 - open,
                      "a list stands in square brackets: " + list};
  if (parse_arguments(inside).node)
    slip.replacement = list;
  return slip;
}

// a ? b
Found half_a_choice(const Scene& scene) {
  if (scene.error != "':' is missing" || scene.text.find('?') == npos)
    return {};
  return ExpressionSlip{scene.text.find('?'), 1,
                        "a choice has two values: condition ? value : "
                        "otherwise"};
}

// list[1:3]
Found slice_of_list(const Scene& scene) {
  if (!scene.rest().starts_with(':'))
    return {};
  const auto open = open_bracket(scene.text, scene.at);
  if (open == npos || open == 0 || scene.text[open] != '[')
    return {};
  const auto close = closing_of(scene.text, open);
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
  ExpressionSlip slip{begin, close + 1 - begin,
                      "a part of a list is given by: " + call};
  if (parse_expression(call).node)
    slip.replacement = call;
  return slip;
}

// {price:.2f}, as Python lays a value out.
Found layout_of_value(const Scene& scene) {
  const auto object = scene.before();
  if (!scene.rest().starts_with(':') || object.empty() ||
      open_bracket(scene.text, scene.at) != npos ||
      !parse_expression(object).node)
    return {};
  return ExpressionSlip{scene.at, scene.rest().size(),
                        "a value is laid out by format(), such as format("
                        "'{:.2}', " +
                            string_of(object) + ")"};
}

} // namespace parlour::script::slip_rules
