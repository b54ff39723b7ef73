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

} // namespace parlour::script::slip_rules
