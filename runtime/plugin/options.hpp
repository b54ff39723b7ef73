// Options of a plug-in: what the settings of a component may configure. The
// plug-in describes each option (name, type, default, sentence), so that
// `parlour check` finds wrong values before anything starts.
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

// The word for the type in listings of options.
std::string_view name_of(OptionType type);

struct OptionDescription {
  std::string name;
  std::string fallback; // used if the settings say nothing
  std::string sentence;
  bool required = false;
  OptionType type = OptionType::text;
  std::vector<std::string> choices = {}; // of a choice
};

// Values by name, as the settings have them.
using Options = std::map<std::string, std::string>;

// Whether the option takes this value. An error of kind Settings says what it
// takes instead. An empty value counts as not given.
Expected<void> check_option(const OptionDescription& option,
                            const std::string& value);

// The value, or the described default if it is missing or empty; empty for an
// option that is not described.
std::string option_value(const Options& options,
                         const std::vector<OptionDescription>& descriptions,
                         const std::string& name);

} // namespace parlour
