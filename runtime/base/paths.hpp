// Where a path leads, links followed: for names in files of a user, which may
// not leave a folder. Nothing needs to be there; nothing is opened.
#pragma once

#include <filesystem>

namespace parlour {

// The path that a file has or would have, links followed.
std::filesystem::path real_path(const std::filesystem::path& path);

// Whether a real path lies below a real folder, which does not itself.
bool is_below(const std::filesystem::path& path,
              const std::filesystem::path& folder);

} // namespace parlour
