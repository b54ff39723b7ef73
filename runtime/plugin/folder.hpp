// File names in a plug-in's options: each must stay inside of one folder, the
// run's data folder or the application's folder.
#pragma once

#include <filesystem>
#include <string>

#include "runtime/base/error.hpp"

namespace parlour {

// The path of `name` in `folder`; the file need not exist. An error of kind
// Settings if the name is empty or absolute, or leaves the folder by ".." or by
// a link. The error names the option and says what to write.
Expected<std::filesystem::path> inside(const std::filesystem::path& folder,
                                       const std::string& name,
                                       const std::string& option);

} // namespace parlour
