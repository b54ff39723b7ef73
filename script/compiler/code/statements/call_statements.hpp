// CallStatements: <call>, <return>.
#pragma once

#include <vector>

#include "script/compiler/code/statements/statement_group.hpp"

namespace parlour::script {

class CallStatements : public StatementGroup {
public:
  using StatementGroup::StatementGroup;

  void call(const Element& element);
  void return_(const Element& element);

private:
  struct Argument {
    const Attribute* expression = nullptr;
    Position position;
  };
  std::vector<Argument> call_arguments(const Element& element,
                                       const FunctionName* function);
  void argument(const Argument& argument, Register target, bool may_bind);
  void call_dynamic(const Element& element, const Attribute& function);
};

} // namespace parlour::script
