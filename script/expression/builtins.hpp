// The built-in functions by their names (language rule 8): one table,
// builtins.def. What they do stands in script/builtins.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace parlour::script {

struct Builtin {
  const char* name;
  std::uint8_t minimum; // arguments
  std::uint8_t maximum;
  const char* sentence;
};

bool is_builtin(std::string_view name);
// For did-you-mean.
const std::vector<std::string>& builtin_names();
// What an instruction holds; nothing where there is none of that name.
std::optional<std::uint16_t> builtin_index(std::string_view name);
const Builtin& builtin(std::uint16_t index);

} // namespace parlour::script
