#include "runtime/message/act_kinds.hpp"

#include <algorithm>

namespace parlour {

const std::vector<std::string>& act_names() {
  static const std::vector<std::string> names{
#define ACT(name, sentence) #name,
#include "runtime/message/acts.def"
#undef ACT
  };
  return names;
}

std::string_view name_of(ActKind kind) {
  return act_names()[static_cast<std::size_t>(kind)];
}

std::optional<ActKind> act_kind(std::string_view name) {
  const auto& names = act_names();
  const auto found = std::ranges::find(names, name);
  if (found == names.end())
    return std::nullopt;
  return static_cast<ActKind>(found - names.begin());
}

} // namespace parlour
