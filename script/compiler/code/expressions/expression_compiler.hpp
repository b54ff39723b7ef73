// Compiles expressions and texts (language rules 3 and 4) to instructions. Code
// is made in one pass over the tree; constants become operands of instructions
// where the instruction set allows it. Constant subexpressions are not folded:
// authors hardly write any, and the sign of a literal is folded by the parser.
//
// A Source goes along with each tree: it knows where the text stands in its
// file, so every message and every instruction gets an exact position.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "script/compiler/code/expressions/code_builder.hpp"

namespace parlour::script {

// A piece of a text: literal, or an expression in {…}.
struct TextPart {
  std::string literal;
  NodePointer node; // null: literal
  Source source;    // of the node
};

// Each function that has a target leaves its value there and releases all
// temporaries.
class ExpressionCompiler {
public:
  explicit ExpressionCompiler(CodeBuilder& builder) : b_(builder) {}

  // -- trees ------------------------------------------------------------------
  // Computes the value into the target register.
  void into(const Node& node, const Source& source, Register target);
  // A register that holds the value: for a local variable its own register,
  // which may be bound to another variable; otherwise a new one.
  Register any(const Node& node, const Source& source);
  // Emits jumps that are taken if the truth of the node is `when`; otherwise
  // the code continues behind. The labels of the jumps are added to `labels`.
  void jump(const Node& node, const Source& source, bool when,
            std::vector<Label>& labels);

  // -- attributes -------------------------------------------------------------
  // Parses the text; null after reporting that it is not well-formed.
  NodePointer parse(const Source& source);
  // Reports what is wrong with a text that is not well-formed.
  void report(const Source& source, const Parsed& parsed);
  // Compiles a value that is always an expression.
  void expression(const Source& source, Register target);
  // Decides by language rule 4.2: the tree if it is an expression, null if it
  // is text.
  NodePointer decide(const Source& source);
  void text_or_expression(const Source& source, Register target);
  // Splits a text into literal pieces and expressions (language rules 4.4 and
  // 4.5).
  static std::vector<TextPart> split_text(const Source& source);
  void text(const Source& source, Register target);

  // Stores register `from` in the target of a <set>. Returns false if the
  // target is not assignable.
  bool assign(const Node& target, const Source& source, Register from);

private:
  void name(const Node& node, const Source& source, Register target);
  void slot(const Node& node, const Source& source, Register target);
  bool is_foreign_field(const Node& node) const;
  void foreign_slot(const Node& node, const Source& source, Register target);
  SlotId slot_id(const Node& node, const Source& source);
  void call(const Node& node, const Source& source, Register target);
  void arguments(const Node& node, const Source& source, Register base);
  void binary(const Node& node, const Source& source, Register target);
  void logical(const Node& node, const Source& source, Register target);
  void choice(const Node& node, const Source& source, Register target);
  void elements(const Node& node, const Source& source, Register target);
  void compare_jump(const Node& node, const Source& source, bool when,
                    std::vector<Label>& labels);
  // Whether the node is a literal, and its value.
  bool constant_of(const Node& node, Box& box);
  // Reports at the node's name or operator, with a correction if one is
  // certain.
  void error(const Node& node, const Source& source, std::string message,
             std::optional<std::string> replacement = {});
  void unknown_function(const Node& node, const Source& source);
  void unknown_name(const Node& node, const Source& source);
  void unknown_target(const Node& node, const Source& source); // of a <set>
  // Whether the name means anything at this place.
  bool is_declared(const std::string& name) const;
  bool is_text(const Source& source) const;
  // Warns if a text was probably meant as an expression.
  void warn_of_text(const Source& source);
  // What an expression mentions; language rule 4.2 decides by it.
  struct Mentions {
    bool quoted = false;
    bool called = false;
    bool declared = false;
    bool undeclared = false;
  };
  void mentions(const Node& node, Mentions& found) const;

  CodeBuilder& b_;
};

// Whether the node is `this.Name`, a slot.
inline bool is_this_field(const Node& node) {
  return node.kind == NodeKind::field &&
         node.children[0]->kind == NodeKind::name &&
         node.children[0]->text == "this";
}

} // namespace parlour::script
