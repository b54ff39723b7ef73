// OpenBody: a body that is being compiled, as the compilers of its statements
// share it.
#pragma once

#include <vector>

#include "script/compiler/code/expressions/expression_compiler.hpp"

namespace parlour::script {

class OpenBody {
public:
  explicit OpenBody(CodeBuilder& code_builder)
      : builder(code_builder), expressions(code_builder) {}
  OpenBody(const OpenBody&) = delete;
  OpenBody& operator=(const OpenBody&) = delete;

  // Compiles the children, except those named in `except`, as a block of their
  // own.
  virtual void block(const Element& parent, ElementNames except = {}) = 0;
  // Compiles them as a body of their own, which runs later or elsewhere.
  virtual void body_apart(const Element& parent, CodeBuilder& into) = 0;

  // A loop that is being compiled; <break> and <continue> add their jumps.
  struct Loop {
    std::vector<Label> breaks;
    std::vector<Label> continues;
    std::size_t transactions = 0; // open when it begins
  };

  CodeBuilder& builder;
  ExpressionCompiler expressions;
  // What is open at the present place; the last is the innermost.
  std::vector<Loop> loops;
  std::vector<Register> transactions; // with the databases' names
  bool in_case = false;

protected:
  ~OpenBody() = default;
};

} // namespace parlour::script
