// Files of an application: their bytes, and which there are. Only regular files
// are read: a named pipe, a socket or a device may block its reader for good.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "runtime/base/error.hpp"

namespace parlour {

inline constexpr std::size_t largest_file = 256 << 20; // bytes

// What lies at `path`, where it is something else than a regular file or a link
// to one: "this is a named pipe, not a file"; "this file cannot be read:
// Permission denied". Opens nothing.
Expected<void> check_is_file(const std::filesystem::path& path);
// The same before a file is written, which need not be there.
Expected<void> check_may_be_file(const std::filesystem::path& path);

// Its bytes, all of them: what has more than `most` is an error. Errors are of
// kind File, as above, and have the file for their place.
Expected<std::string> read_file(const std::filesystem::path& path,
                                std::size_t most = largest_file);

// The paths of a folder that end so (".xml"), in order; hidden ones, such as
// an editor's, left out. Whatever lies there: a folder or a pipe as well.
Expected<std::vector<std::filesystem::path>>
list_files(const std::filesystem::path& folder, const std::string& extension);

// Whether something lies there, a link that leads nowhere too.
bool is_there(const std::filesystem::path& path);

} // namespace parlour
