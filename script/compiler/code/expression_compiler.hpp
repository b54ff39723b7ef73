// From expressions and texts (language rules 3 and 4) to instructions.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "script/compiler/code/code_builder.hpp"

namespace parlour::script {

// A piece of a text: literal, or what `{expr}` embeds.
struct TextPart {
  std::string literal;
  NodePointer node; // null: literal
  Source source;    // of the node
};

class ExpressionCompiler {
public:
  explicit ExpressionCompiler(CodeBuilder& builder) : b_(builder) {}

  // -- trees ------------------------------------------------------------------
  void into(const Node& node, const Source& source, Register target);
  // The register that holds it: a local's own, perhaps bound to a variable, or
  // a new one.
  Register any(const Node& node, const Source& source);
  // Jumps when its truth is `when`; falls through otherwise.
  void jump(const Node& node, const Source& source, bool when,
            std::vector<Label>& labels);

  // -- attributes -------------------------------------------------------------
  // Null and a finding where it is not well-formed.
  NodePointer parse(const Source& source);
  // Tells what is wrong with one that is not well-formed.
  void report(const Source& source, const Parsed& parsed);
  // Always an expression.
  void expression(const Source& source, Register target);
  // Language rule 4: the tree if it is an expression, null if it is text.
  NodePointer decide(const Source& source);
  void text_or_expression(const Source& source, Register target);
  static std::vector<TextPart> split_text(const Source& source);
  void text(const Source& source, Register target);

  // Stores register `from` where a <set> says; false: not assignable.
  bool assign(const Node& target, const Source& source, Register from);

private:
  void name(const Node& node, const Source& source, Register target);
  void slot(const Node& node, const Source& source, Register target);
  SlotId slot_id(const Node& node, const Source& source);
  void call(const Node& node, const Source& source, Register target);
  void arguments(const Node& node, const Source& source, Register base);
  void binary(const Node& node, const Source& source, Register target);
  void logical(const Node& node, const Source& source, Register target);
  void choice(const Node& node, const Source& source, Register target);
  void elements(const Node& node, const Source& source, Register target);
  void compare_jump(const Node& node, const Source& source, bool when,
                    std::vector<Label>& labels);
  bool constant_of(const Node& node, Box& box);
  // At the node's name or operator, with a correction where one is sure.
  void error(const Node& node, const Source& source, std::string message,
             std::optional<std::string> replacement = {});
  void unknown_function(const Node& node, const Source& source);
  void unknown_name(const Node& node, const Source& source);
  void unknown_target(const Node& node, const Source& source); // of a <set>
  bool is_declared(const std::string& name) const;
  bool is_text(const Source& source) const;
  void warn_of_text(const Source& source);
  struct Mentions {
    bool quoted = false;
    bool called = false;
    bool declared = false;
    bool undeclared = false;
  };
  void mentions(const Node& node, Mentions& found) const;

  CodeBuilder& b_;
};

inline bool is_this_field(const Node& node) {
  return node.kind == NodeKind::field &&
         node.children[0]->kind == NodeKind::name &&
         node.children[0]->text == "this";
}

} // namespace parlour::script
