// The table as an array, with an index by name that is made at first use.

#include "script/expression/builtins.hpp"

#include <array>
#include <unordered_map>

namespace parlour::script {

namespace {

constexpr std::uint8_t many = 255;

const std::array table{
#define BUILTIN(name, minimum, maximum, function, sentence)                    \
  Builtin{name, minimum, maximum, sentence},
#include "script/expression/builtins.def"
#undef BUILTIN
};

} // namespace

std::optional<std::uint16_t> builtin_index(std::string_view name) {
  static const auto index = [] {
    std::unordered_map<std::string_view, std::uint16_t> all;
    for (std::uint16_t i = 0; i < table.size(); ++i)
      all.emplace(table[i].name, i);
    return all;
  }();
  const auto there = index.find(name);
  if (there == index.end())
    return {};
  return there->second;
}

const Builtin& builtin(std::uint16_t index) {
  return table[index];
}

bool is_builtin(std::string_view name) {
  return builtin_index(name).has_value();
}

const std::vector<std::string>& builtin_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const auto& entry : table)
      all.emplace_back(entry.name);
    return all;
  }();
  return names;
}

} // namespace parlour::script
