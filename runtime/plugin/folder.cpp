#include "runtime/plugin/folder.hpp"

#include "runtime/base/text/paths.hpp"

namespace parlour {

namespace fs = std::filesystem;

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
  // Compares the real paths, so a link inside of the folder cannot lead out of
  // it.
  const auto base = fs::current_path() / folder;
  auto full = (base / path).lexically_normal();
  if (!is_below(real_path(full), real_path(base)))
    return wrong("'" + name + "' leaves its folder");
  return full;
}

} // namespace parlour
