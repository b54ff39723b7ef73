// How a component is operated: how many instances there are, how long a call
// may take, and where it runs (engine rules 7.1 and 7.3; docs/components.md).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "runtime/base/clock.hpp"
#include "runtime/base/defaults.hpp"
#include "runtime/base/error.hpp"

namespace parlour {

// How many instances of a component there are and who shares each.
struct Scope {
  enum class Kind : std::uint8_t {
    usual,   // as the plug-in describes itself: inline or node
    node,    // one instance for all
    seat,    // one for each seat
    session, // one for each conversation
    pool,    // several instances that share the work
    in_turn  // "inline": called in the session's own turn, without a mailbox
  };
  Kind kind = Kind::usual;
  std::size_t instances = 1; // of a pool; 0: none until a script loads it

  bool operator==(const Scope&) const = default;
};

// Reads "node", "seat", "session", "inline" or "pool(4)" (1 to 64 instances),
// each but the pool also with "loaded" in front. An error of kind Settings says
// what was expected.
Expected<Scope> parse_scope(std::string_view text);

struct ComponentPolicy {
  Scope scope;
  // The longest time for one call into the plug-in. A call that takes longer
  // counts as hanging. Without one the limit is that of call_deadline.
  std::optional<Milliseconds> deadline{};
  // "process": the plug-in runs in a process of its own; empty: in this one.
  std::string host;
  // The configured seat that it belongs to: its scope is then "seat", and it
  // has an instance there and nowhere else. Empty: to none.
  std::string seat = {};

  bool operator==(const ComponentPolicy&) const = default;
};

} // namespace parlour
