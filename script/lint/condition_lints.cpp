// constant-condition: a condition, or a part of it, that depends on nothing.
//
//   <if cond="x == 1 or 2">       2 always counts as true
//   <if cond="[]">                an empty list always counts as false
#include <algorithm>
#include <optional>

#include "runtime/base/value.hpp"
#include "script/lint/passes.hpp"

namespace parlour::script::lint {

namespace {

bool compares(const Node& node) {
  return node.kind == NodeKind::binary && node.operation <= Operator::in;
}

// A literal other than `true` and `false`, which are written deliberately.
bool is_literal(const Node& node) {
  using enum NodeKind;
  return node.kind == integer || node.kind == number || node.kind == string ||
         node.kind == list || node.kind == map;
}

bool counts_as_true(const Node& node) {
  return node.kind == NodeKind::integer  ? node.integer != 0
         : node.kind == NodeKind::number ? node.number != 0
         : node.kind == NodeKind::string ? !node.text.empty()
                                         : !node.children.empty();
}

// The literal as its author wrote it; containers are abbreviated.
std::string written(const Node& node) {
  switch (node.kind) {
  case NodeKind::integer:
    return std::to_string(node.integer);
  case NodeKind::number:
    return number_text(node.number);
  case NodeKind::string:
    return quoted_text(node.text);
  default:
    return node.kind == NodeKind::list ? "[…]" : "{…}";
  }
}

// The leftmost offset of the whole subtree: a binary node's own is its
// operator's.
std::size_t begin_of(const Node& node) {
  std::size_t begin = node.offset;
  for (const auto& child : node.children)
    begin = std::min(begin, begin_of(*child));
  return begin;
}

// Examines the truth values in one expression.
class ConditionLint {
public:
  explicit ConditionLint(Findings& findings) : findings_(findings) {}

  void look_at(const Node& node, const Source& source);

private:
  void decides(const Node& node, const Source& source);
  void report(const Node& literal, const Source& source, const Node* joined);
  std::string compared_again(const Node& joined, const Node& literal,
                             const Source& source) const;

  Findings& findings_;
};

// The correction "x == 1 or x == 2" for "x == 1 or 2"; empty if the expression
// has another form.
std::string ConditionLint::compared_again(const Node& joined,
                                          const Node& literal,
                                          const Source& source) const {
  const auto& first = *joined.children[0];
  if (&literal == &first || first.kind != NodeKind::binary ||
      first.operation > Operator::greater_equal)
    return {};
  const auto begin = begin_of(first);
  const auto end = source.text.find_first_not_of(
      "=!<>", first.offset); // eq continues with letters
  const auto sign = source.text.substr(
      first.offset, end == first.offset ? 2 : end - first.offset);
  const auto left = source.text.substr(begin, first.offset - begin);
  const auto all = source.text.substr(begin, literal.offset - begin);
  if (all.find_first_of("()") != std::string_view::npos)
    return {};
  return std::string(all) + std::string(left) + std::string(sign) + " " +
         written(literal);
}

// Shows how the comparison was probably meant, if that can be said.
void ConditionLint::report(const Node& literal, const Source& source,
                           const Node* joined) {
  const auto shown = written(literal);
  const auto again =
      joined ? compared_again(*joined, literal, source) : std::string();
  warn(findings_, "constant-condition", source.spot(literal.offset),
       shown + " always counts as " +
           (counts_as_true(literal) ? "true" : "false") +
           (again.empty() ? "; compare it with something, such as x == " + shown
                          : "; compare each time: " + again));
}

// A node of which only the truth counts.
void ConditionLint::decides(const Node& node, const Source& source) {
  if (is_literal(node))
    return report(node, source, nullptr);
  if (node.kind == NodeKind::invert)
    return decides(*node.children[0], source);
  if (node.kind != NodeKind::both && node.kind != NodeKind::either)
    return;
  for (const auto& child : node.children)
    if (is_literal(*child))
      report(*child, source, &node);
    else
      decides(*child, source);
}

// If a value is expected, `x or 'nothing'` is a usual way to write a default,
// so there only comparisons beside the literal are suspicious.
void ConditionLint::look_at(const Node& node, const Source& source) {
  if (source.wanted == Wanted::condition)
    decides(node, source);
  visit_below(node, [&](const Node& one) {
    if (one.kind == NodeKind::choice)
      decides(*one.children[0], source);
    const bool joins =
        one.kind == NodeKind::both || one.kind == NodeKind::either;
    if (joins && source.wanted != Wanted::condition &&
        std::any_of(one.children.begin(), one.children.end(),
                    [](const auto& child) { return compares(*child); }))
      for (const auto& child : one.children)
        if (is_literal(*child))
          report(*child, source, &one);
  });
}

} // namespace

void lint_conditions(const LintContext& context, Findings& findings) {
  ConditionLint lint(findings);
  walk(context, false, [&](const Element& element, const ElementRule& rule) {
    visit_nodes(element, rule, [&](const Node& node, const Source& source) {
      // Loops that never end have a lint of their own.
      if (!element.is("while") || !is_literal(node))
        lint.look_at(node, source);
    });
  });
}

} // namespace parlour::script::lint
