// MessageStatements: <post>, <request>, <fire>.
#pragma once

#include "script/compiler/code/statements/effect_group.hpp"

namespace parlour::script {

class MessageStatements : public EffectGroup {
public:
  using EffectGroup::EffectGroup;

  void post(const Element& element);
  void request(const Element& element);
  void fire(const Element& element);
};

} // namespace parlour::script
