// LoopStatements: <for>, <while>, <break>, <continue>.
#pragma once

#include "script/compiler/code/statements/statement_group.hpp"

namespace parlour::script {

class LoopStatements : public StatementGroup {
public:
  using StatementGroup::StatementGroup;

  void for_(const Element& element);
  void while_(const Element& element);
  void break_(const Element& element);
  void continue_(const Element& element);

private:
  void for_each(const Element& element);
  void end_loop();
};

} // namespace parlour::script
