// EffectStatements: statements that are no more than an effect. Such a new one
// needs a row in plain_effects (effect_statements.cpp).
#pragma once

#include "script/compiler/code/statements/effect_group.hpp"

namespace parlour::script {

class EffectStatements : public EffectGroup {
public:
  using EffectGroup::EffectGroup;

  void effect(const Element& element);
};

} // namespace parlour::script
