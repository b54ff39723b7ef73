// The table of lints (lints.def) as data. Immutable; safe from any thread.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace parlour::script::lint {

struct Lint {
  std::string name; // "unread-variable"
  std::string sentence;
};

// In the table's order.
const std::vector<Lint>& lints();

bool is_lint(std::string_view name);

} // namespace parlour::script::lint
