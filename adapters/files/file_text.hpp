// One file's text: read, replaced, added to, removed. `name` is one part, in an
// open folder.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "adapters/files/folder.hpp"

namespace parlour::adapters {

Expected<std::string> read_text(const Folder& folder, const std::string& name,
                                std::size_t most_bytes);

// By a temporary file that takes its place when it is safe on the disk: readers
// see the old text or the new one.
Expected<void> write_text(const Folder& folder, const std::string& name,
                          std::string_view text, std::size_t most_bytes);

// All of it or nothing; makes a missing file. Several at once come one after
// the other, of other processes too.
Expected<void> append_text(const Folder& folder, const std::string& name,
                           std::string_view text, std::size_t most_bytes);

Expected<void> remove_file(const Folder& folder, const std::string& name);

} // namespace parlour::adapters
