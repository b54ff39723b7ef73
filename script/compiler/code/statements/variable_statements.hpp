// VariableStatements: <var>, <const>, <set>, <object>, <getlist>, <append>.
#pragma once

#include "script/compiler/code/statements/statement_group.hpp"

namespace parlour::script {

class VariableStatements : public StatementGroup {
public:
  using StatementGroup::StatementGroup;

  void declare_variable(const Element& element);
  void declare_constant(const Element& element);
  void set(const Element& element);
  void object(const Element& element);
  void get_list(const Element& element);
  void append(const Element& element);

private:
  void define(const Element& element, bool is_constant);
};

} // namespace parlour::script
