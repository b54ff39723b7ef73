// What keys are called: "space", "f5", "k", "page-down", "code-164" for the one
// of that number, "any" for every key of a device. Pure functions.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "runtime/base/error.hpp"

namespace parlour::adapters {

struct KeyName {
  // As the kernel counts keys (linux/input-event-codes.h); nothing: any key.
  std::optional<std::uint16_t> code;
  // The byte that a terminal sends for it; nothing: none, or several.
  std::optional<char> typed;

  bool operator==(const KeyName&) const = default;
};

// Refuses what is no key, with what there is.
Expected<KeyName> find_key(const std::string& name);

} // namespace parlour::adapters
