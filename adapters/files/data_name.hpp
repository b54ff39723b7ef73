// Names of files as scripts write them: relative to the data folder, parts
// separated by '/'. Text alone; what the parts are on the disk is looked at by
// `folder`.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/error.hpp"

namespace parlour::adapters {

// The parts, at least one. An error of kind File for every name that is not
// plain: absolute, '..', '.', an empty part, a leading dot (those files are the
// platform's own), a control character, a backslash.
Expected<std::vector<std::string>> split_name(std::string_view name);

// How a name stands in messages: quoted, shortened, control characters as '?'.
std::string shown_name(std::string_view name);

} // namespace parlour::adapters
