// Options of a plug-in: what the settings may say to it. Each is described by
// the plug-in (name, type, default, sentence), so that `check` finds what it
// would refuse before anything starts.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/error.hpp"

namespace parlour {

// clang-format off
#define PARLOUR_OPTION_TYPES(X) \
  X(text, "text", "any text") \
  X(boolean, "boolean", "true or false") \
  X(integer, "integer", "a whole number") \
  X(number, "number", "a number") \
  X(duration, "duration", "a time such as 200ms, 1.5s or 2m") \
  X(choice, "choice", "one of a few words")
// clang-format on

enum class OptionType : std::uint8_t {
#define X(name, text, sentence) name,
  PARLOUR_OPTION_TYPES(X)
#undef X
};

std::string_view name_of(OptionType type);

struct OptionDescription {
  std::string name;
  std::string fallback; // what holds where the settings say nothing
  std::string sentence;
  bool required = false;
  OptionType type = OptionType::text;
  std::vector<std::string> choices = {}; // of a choice
};

using Options = std::map<std::string, std::string>;

// Whether the option takes such a value. An error of kind Settings says what
// it takes instead. An empty value is as good as none.
Expected<void> check_option(const OptionDescription& option,
                            const std::string& value);

// The value, or else what the description falls back on; empty for an option
// that is not described.
std::string option_value(const Options& options,
                         const std::vector<OptionDescription>& descriptions,
                         const std::string& name);

} // namespace parlour
