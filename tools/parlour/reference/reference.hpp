// The reference: looks up elements, built-in functions and roles by name, and
// finds out what else has an attribute, command or event of a name. The tables
// do not change, so all functions are pure and safe to call from any thread.
#pragma once

#include <string>
#include <vector>

#include "runtime/base/error.hpp"
#include "tools/parlour/reference/entry.hpp"

namespace parlour::tools {

// The entries with a name: all elements of that name, a function, or a role
// (also by an alias). Empty if there are none.
std::vector<Entry> entries_of(const std::string& name);

// A line for each attribute, command or event of that name, with what it
// belongs to: "<speak interrupt>: whether the user may break in".
std::vector<std::string> holders_of(const std::string& name);

// A line for each sentence of the reference that contains the word: "<sessions
// no-input-after>: silence …".
std::vector<std::string> mentions_of(const std::string& word);

// Every name that can be looked up, once: for completion and "did you mean".
std::vector<std::string> reference_names();

// The answer to `parlour help NAME`: the entries, what else has the name, or
// where the word is mentioned. A test keeps all answers within `screen` lines.
// An error of kind Settings if nothing is known; it suggests the nearest name,
// of the reference or of `others`.
Expected<std::string> reference_text(const std::string& name,
                                     const std::vector<std::string>& others);

// The lines of a terminal that an answer may fill.
inline constexpr std::size_t screen = 48;

} // namespace parlour::tools
