// Where paths lead when links are followed. The checks that keep a user's file
// names inside of a folder need this. Nothing has to exist, and nothing is
// opened.
#pragma once

#include <filesystem>

namespace parlour {

// The path with links resolved, as far as it exists.
std::filesystem::path real_path(const std::filesystem::path& path);

// Whether `path` lies inside of `folder`. Both must be real paths. A folder is
// not below itself.
bool is_below(const std::filesystem::path& path,
              const std::filesystem::path& folder);

} // namespace parlour
