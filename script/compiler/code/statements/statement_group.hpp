// StatementGroup: what the compilers of statements share. Each group of
// statements has a class of its own that is made for one statement:
//
//   LoopStatements(body).while_(element);
#pragma once

#include <string>
#include <vector>

#include "script/compiler/code/statements/open_body.hpp"

namespace parlour::script {

class StatementGroup {
public:
  explicit StatementGroup(OpenBody& body)
      : body_(body), b_(body.builder), expressions_(body.expressions) {}

protected:
  // The children as a block of their own.
  void block(const Element& parent, ElementNames except = {}) {
    body_.block(parent, except);
  }
  // For coverage: a branch begins.
  void reached(const Element& element);
  // Compiles the condition of an <if> or <while>; see statement_group.cpp.
  std::vector<Label> condition(const Element& element, const char* attribute);
  // The value of `expr`; unknown without it.
  void initial(const Element& element, Register target);
  // Stores register `from` in the variable that `return` names, which is
  // declared if it is not visible; without the attribute the value is dropped.
  // Releases `from` and the temporaries above it.
  void store_result(const Attribute* attribute, Register from);
  const Attribute* required(const Element& element, const char* name);
  void error(Position position, std::string message) {
    b_.findings.error(position, std::move(message));
  }

  OpenBody& body_;
  CodeBuilder& b_;
  ExpressionCompiler& expressions_;
};

} // namespace parlour::script
