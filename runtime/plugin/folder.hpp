// Files that a plug-in's options name: below the one folder that is meant, the
// run's data or the application's, and never out of it.
#pragma once

#include <filesystem>
#include <string>

#include "runtime/base/error.hpp"

namespace parlour {

// The file `name` of `folder`, which need not be there. An error of kind
// Settings, for a name that is empty or absolute, or that leaves the folder, by
// ".." or by a link, names the option and the way out.
Expected<std::filesystem::path> inside(const std::filesystem::path& folder,
                                       const std::string& name,
                                       const std::string& option);

} // namespace parlour
