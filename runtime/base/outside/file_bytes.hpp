// Reading an application's files. Only regular files are read, because opening
// or reading a named pipe, a socket or a device could block for ever.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "runtime/base/error.hpp"

namespace parlour {

inline constexpr std::size_t largest_file = 256 << 20; // bytes

// Checks that `path` is a regular file or a link to one, without opening it.
// Errors are of kind File and read as "this is a named pipe, not a file" or
// "this file cannot be read: Permission denied".
Expected<void> check_is_file(const std::filesystem::path& path);
// The same, but a path that does not exist is fine, too: the file may be
// created.
Expected<void> check_may_be_file(const std::filesystem::path& path);

// Reads the whole file. A file of more than `most` bytes is an error. Errors
// are of kind File and have the file as their place.
Expected<std::string> read_file(const std::filesystem::path& path,
                                std::size_t most = largest_file);

// The paths in a folder with that extension (".xml"), sorted. Hidden files,
// such as an editor's backups, are left out. The entries are not checked: a
// folder or a pipe may be among them.
Expected<std::vector<std::filesystem::path>>
list_files(const std::filesystem::path& folder, const std::string& extension);

// Whether something exists at `path`; a dangling link counts.
bool is_there(const std::filesystem::path& path);

} // namespace parlour
