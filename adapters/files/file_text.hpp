// Reads, replaces, extends and removes the text of one file. `name` is one
// part, a file in an open folder. All errors have the kind File. The functions
// block.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "adapters/files/folder.hpp"

namespace parlour::adapters {

// Fails if the file is larger than `max_bytes` or is not UTF-8.
Expected<std::string> read_text(const Folder& folder, const std::string& name,
                                std::size_t max_bytes);

// Writes a temporary file and renames it when it is safe on the disk: readers
// see either the old text or the new one, even after a loss of power.
Expected<void> write_text(const Folder& folder, const std::string& name,
                          std::string_view text, std::size_t max_bytes);

// Appends the whole text or nothing; creates a missing file. A lock orders
// several writers, including other processes.
Expected<void> append_text(const Folder& folder, const std::string& name,
                           std::string_view text, std::size_t max_bytes);

// Removes a regular file.
Expected<void> remove_file(const Folder& folder, const std::string& name);

} // namespace parlour::adapters
