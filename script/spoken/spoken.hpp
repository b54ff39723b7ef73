// How values are spoken, by kind (language rule 8.12). The kinds are in
// spoken.def.
//
// The result depends on the value, its kind and the present date only, so the
// same inputs give the same words.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/clock.hpp"
#include "runtime/base/text/decimal.hpp"

namespace parlour::script {

// A value to speak, in the two forms that the kinds need.
struct ToSay {
  std::string text;              // as it is printed
  std::optional<Decimal> number; // if it is a number or is written like one
  Timestamp now = 0;             // to tell which dates need a year
};

// The words for a value. A value that does not have the form of its kind is
// given as it is printed.
std::string spoken(const ToSay& value, std::string_view kind);

bool is_spoken_kind(std::string_view kind);
const std::vector<std::string>& spoken_kinds(); // candidates for "did you mean"

} // namespace parlour::script
