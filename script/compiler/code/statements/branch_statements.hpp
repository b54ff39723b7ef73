// BranchStatements: <if>, <switch>, <confirm>.
#pragma once

#include <optional>
#include <vector>

#include "script/compiler/code/expressions/table_builder.hpp"
#include "script/compiler/code/statements/effect_group.hpp"

namespace parlour::script {

class BranchStatements : public EffectGroup {
public:
  using EffectGroup::EffectGroup;

  void if_(const Element& element);
  void switch_(const Element& element);
  void confirm(const Element& element);
  // The same about all slots of the topic. After a no, what stands in `refused`
  // runs, or what is to be changed is asked; the body ends there.
  void summary(const Element* refused, bool only_if_unsure);

private:
  struct Case {
    const Element* element;
    Label label;
    std::optional<Box> constant; // in the jump table
  };
  struct Switch {
    Register value;
    std::optional<TableBuilder> table;
    std::vector<Case> cases;
  };

  void test(Switch& arms, const Element& element);
  // The jump tables in front of conditions.
  std::optional<Box> compared(std::uint32_t start);
  std::optional<TableBuilder> enter_by_table(std::uint32_t& start,
                                             std::vector<Label>& otherwise);
};

} // namespace parlour::script
