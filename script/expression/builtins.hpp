// The names and argument counts of the built-in functions (language rule 8),
// from builtins.def. script/builtins implements them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace parlour::script {

// One entry of the table; lives as long as the process.
struct Builtin {
  const char* name;
  std::uint8_t minimum; // arguments
  std::uint8_t maximum;
  const char* sentence;
};

bool is_builtin(std::string_view name);
// All names, as candidates for "did you mean".
const std::vector<std::string>& builtin_names();
// The position in the table, which the call instruction holds; nothing if there
// is no such function. Takes constant time.
std::optional<std::uint16_t> builtin_index(std::string_view name);
const Builtin& builtin(std::uint16_t index);

} // namespace parlour::script
