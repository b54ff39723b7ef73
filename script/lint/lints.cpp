// The table lints.def as a list.

#include "script/lint/lints.hpp"

#include <algorithm>

namespace parlour::script::lint {

const std::vector<Lint>& lints() {
  static const std::vector<Lint> table = {
#define LINT(name, sentence) {name, sentence},
#include "script/lint/lints.def"
#undef LINT
  };
  return table;
}

bool is_lint(std::string_view name) {
  return std::any_of(lints().begin(), lints().end(),
                     [&](const Lint& one) { return one.name == name; });
}

} // namespace parlour::script::lint
