// QueryStatements: <querydb>.
#pragma once

#include <string_view>
#include <vector>

#include "script/compiler/code/statements/effect_group.hpp"

namespace parlour::script {

class QueryStatements : public EffectGroup {
public:
  using EffectGroup::EffectGroup;

  void query(const Element& element);

private:
  // The statement into `target` and the list of its bound values into `values`.
  void sql(const Attribute& attribute, const Attribute* args, Register target,
           Register values);
  void bound_sql(const Source& source, std::vector<NodePointer> arguments,
                 const Source& arguments_source, Register target,
                 Register values);
  void joined_sql(const Node& node, const Source& source);
  void impure_sql(std::string_view name, const Source& source);
};

} // namespace parlour::script
