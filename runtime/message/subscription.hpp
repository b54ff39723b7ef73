// Subscription: says that a session receives events that belong to no session
// (language rule 12.15).
#pragma once

#include <string>

namespace parlour {

struct Subscription {
  std::string source;  // a component, a role or "*"
  std::string command; // "*" means any

  bool operator==(const Subscription&) const = default;
};

} // namespace parlour
