// BranchStatements: <if>, <switch>, <confirm>.
#pragma once

#include <optional>
#include <vector>

#include "script/compiler/code/effect_group.hpp"
#include "script/compiler/code/table_builder.hpp"

namespace parlour::script {

class BranchStatements : public EffectGroup {
public:
  using EffectGroup::EffectGroup;

  void if_(const Element& element);
  void switch_(const Element& element);
  void confirm(const Element& element);

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
