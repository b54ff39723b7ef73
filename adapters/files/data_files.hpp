// The files of an application's data folder, for its scripts (language rules
// 11.5 to 11.8). Whole texts in UTF-8, nothing outside of the folder, replaced
// all at once or not at all.
#pragma once

#include <filesystem>

#include "runtime/base/files.hpp"

namespace parlour::adapters {

// `folder` is absolute. It need not be there: the first file that is written
// makes it.
FileAccess data_files(std::filesystem::path folder);

} // namespace parlour::adapters
