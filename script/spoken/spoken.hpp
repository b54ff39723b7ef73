// How values are said, by kind (language rule 8.12): one table, spoken.def.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/clock.hpp"
#include "runtime/base/decimal.hpp"

namespace parlour::script {

struct ToSay {
  std::string text;              // as it is printed
  std::optional<Decimal> number; // which it is, or is written like
  Timestamp now = 0;
};

// What does not have the form of its kind is said as it is printed.
std::string spoken(const ToSay& value, std::string_view kind);

bool is_spoken_kind(std::string_view kind);
const std::vector<std::string>& spoken_kinds(); // for did-you-mean

} // namespace parlour::script
