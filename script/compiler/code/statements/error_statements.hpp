// ErrorStatements: <try>, <throw>, and the <catch> of others.
#pragma once

#include "script/compiler/code/statements/statement_group.hpp"

namespace parlour::script {

class ErrorStatements : public StatementGroup {
public:
  using StatementGroup::StatementGroup;

  void try_(const Element& element);
  void throw_(const Element& element);
  // Guards what was emitted since `from` by a handler, which may be null.
  void catch_errors(std::uint32_t from, const Element* handler);
};

} // namespace parlour::script
