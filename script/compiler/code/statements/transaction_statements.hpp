// TransactionStatements: <transaction>, and its end by other statements.
#pragma once

#include "script/compiler/code/statements/effect_group.hpp"

namespace parlour::script {

class TransactionStatements : public EffectGroup {
public:
  using EffectGroup::EffectGroup;

  void transaction(const Element& element);
  // Commits the transactions that were opened since `outside` were open.
  void end(std::size_t outside);
};

} // namespace parlour::script
