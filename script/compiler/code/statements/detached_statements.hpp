// DetachedStatements: <timer>, <transit>, whose statements run later or
// elsewhere, with the locals that they capture.
#pragma once

#include <vector>

#include "script/compiler/code/statements/effect_group.hpp"

namespace parlour::script {

class DetachedStatements : public EffectGroup {
public:
  using EffectGroup::EffectGroup;

  void timer(const Element& element);
  void transit(const Element& element);

private:
  CodeId detached(const Element& element, bool in_timer,
                  std::vector<const Local*>& captured);
  Register capture(const std::vector<const Local*>& captured);
};

} // namespace parlour::script
