// How a component is kept: how many instances of it there are, how long it may
// take, where it runs (engine rules 7.1 and 7.3; docs/components.md).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "runtime/base/clock.hpp"
#include "runtime/base/defaults.hpp"
#include "runtime/base/error.hpp"

namespace parlour {

struct Scope {
  enum class Kind : std::uint8_t {
    usual,   // as the plug-in describes itself: inline, else node
    node,    // one instance for all
    seat,    // one for each seat
    session, // one for each conversation
    pool,    // several that share the work
    in_turn  // "inline": asked in the session's own turn, without a mailbox
  };
  Kind kind = Kind::usual;
  std::size_t instances = 1; // of a pool

  bool operator==(const Scope&) const = default;
};

// "node", "seat", "session", "pool(4)" (1 to 64), "inline"; an error of kind
// Settings says what was expected.
Expected<Scope> parse_scope(std::string_view text);

struct Upkeep {
  Scope scope;
  // For one call into the plug-in; one that takes longer hangs.
  Milliseconds deadline = defaults::component_deadline;
  // Where the plug-in runs; empty: in this process.
  std::string host;

  bool operator==(const Upkeep&) const = default;
};

} // namespace parlour
