#include "runtime/base/text/paths.hpp"

#include <algorithm>
#include <iterator>
#include <system_error>

namespace parlour {

namespace fs = std::filesystem;

fs::path real_path(const fs::path& path) {
  std::error_code ignored;
  auto found = fs::weakly_canonical(path, ignored);
  return found.empty() ? path.lexically_normal() : found;
}

// Compares part by part, so "/data2" is not below "/data". A folder that is
// written with a slash at its end has an empty last part.
bool is_below(const fs::path& path, const fs::path& folder) {
  const auto [end, rest] =
      std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  return (end == folder.end() && rest != path.end()) ||
         (end != folder.end() && end->empty() &&
          std::next(end) == folder.end());
}

} // namespace parlour
