#include "runtime/plugin/folder.hpp"

#include <algorithm>

namespace parlour {

namespace {

namespace fs = std::filesystem;

// The path that a file has or would have, links followed.
fs::path real(const fs::path& path) {
  std::error_code ignored;
  auto found = fs::weakly_canonical(path, ignored);
  return found.empty() ? path.lexically_normal() : found;
}

bool is_below(const fs::path& path, const fs::path& folder) {
  const auto [end, rest] =
      std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  return (end == folder.end() && rest != path.end()) ||
         (end != folder.end() && end->empty() &&
          std::next(end) == folder.end());
}

} // namespace

Expected<fs::path> inside(const fs::path& folder, const std::string& name,
                          const std::string& option) {
  auto wrong = [&](const std::string& what) {
    return fail(ErrorKind::settings, "option '" + option + "': " + what +
                                         "; name a file by its path below " +
                                         folder.string());
  };
  const fs::path path(name);
  if (name.empty() || name.find('\0') != std::string::npos)
    return wrong("there is no name");
  if (path.is_absolute())
    return wrong("'" + name + "' is an absolute path");
  const auto base = fs::current_path() / folder;
  auto full = (base / path).lexically_normal();
  if (!is_below(real(full), real(base)))
    return wrong("'" + name + "' leaves its folder");
  return full;
}

} // namespace parlour
