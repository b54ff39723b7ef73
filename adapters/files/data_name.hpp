// Names of files as scripts write them: relative to the data folder, with parts
// separated by '/'. Only the text is checked here; folder.hpp checks what the
// parts are on the disk.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/error.hpp"

namespace parlour::adapters {

// Returns the parts, at least one. The error, of kind File, refuses a name that
// is absolute or contains '..', '.', an empty part, a leading dot (such files
// belong to the platform), a control character or a backslash.
Expected<std::vector<std::string>> split_name(std::string_view name);

// The name as messages show it: in quotes, shortened, with control characters
// as '?'.
std::string shown_name(std::string_view name);

} // namespace parlour::adapters
