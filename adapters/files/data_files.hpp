// Gives scripts access to the files of the application's data folder (language
// rules 11.5 to 11.8). Files are read and written as whole texts in UTF-8. A
// name cannot lead out of the folder, and a file is replaced completely or not
// at all.
#pragma once

#include <filesystem>

#include "runtime/base/outside/files.hpp"

namespace parlour::adapters {

// Returns the function that carries out requests. `folder` is absolute; it is
// created when the first file is written. Thread-safe; blocks while the disk is
// busy.
FileAccess data_files(std::filesystem::path folder);

} // namespace parlour::adapters
