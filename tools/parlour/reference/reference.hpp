// The reference: every element, built-in function and role by its name, and
// who has an attribute, command or event of a name.
#pragma once

#include <string>
#include <vector>

#include "runtime/base/error.hpp"
#include "tools/parlour/reference/entry.hpp"

namespace parlour::tools {

// Elements (of several of a name, each), a function, a role by name or alias.
std::vector<Entry> entries_of(const std::string& name);

// "an attribute of <speak>: true or false; whether the user may break in", a
// line each.
std::vector<std::string> holders_of(const std::string& name);

// In whose sentences a word stands: "<sessions no-input-after>: silence …".
std::vector<std::string> mentions_of(const std::string& word);

// All that may be asked for, each once.
std::vector<std::string> reference_names();

// What is told of a name or word, never more than `screen` lines; an error
// where nothing is known of it, with the nearest of the names, `others` too.
Expected<std::string> reference_text(const std::string& name,
                                     const std::vector<std::string>& others);

inline constexpr std::size_t screen = 48; // lines

} // namespace parlour::tools
