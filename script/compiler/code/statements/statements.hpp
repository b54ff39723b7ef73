// StatementCompiler: compiles the statements of one body. It knows which class
// compiles which statement (statement_group.hpp). The validator has checked all
// elements and attributes against the element table before; whatever it could
// not check, such as names, is checked here.
//
// A new statement needs a row in elements.def and either a row in plain_effects
// (effect_statements.cpp), if it only performs an effect, or a function in a
// group and an entry in find() (statements.cpp).
#pragma once

#include "script/compiler/code/statements/open_body.hpp"

namespace parlour::script {

// Made for one body and used once.
class StatementCompiler final : public OpenBody {
public:
  using OpenBody::OpenBody;

  void block(const Element& parent, ElementNames except = {}) override;
  void body_apart(const Element& parent, CodeBuilder& into) override;
  // Compiles the <param>s of a function, with the code for their defaults.
  void parameters(const Element& function);

private:
  void statement(const Element& element);
};

} // namespace parlour::script
