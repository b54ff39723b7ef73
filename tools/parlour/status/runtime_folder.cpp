#include "tools/parlour/status/runtime_folder.hpp"

#include <cerrno>
#include <cstring>
#include <string>

#include <sys/stat.h>
#include <unistd.h>

namespace parlour::tools {

namespace fs = std::filesystem;

fs::path runtime_folder(const Places& places) {
  const auto given =
      places.environment ? places.environment("XDG_RUNTIME_DIR") : std::nullopt;
  if (given && fs::path(*given).is_absolute())
    return fs::path(*given) / "parlour";
  std::error_code code;
  const auto temporary = fs::temp_directory_path(code);
  return (code ? fs::path("/tmp") : temporary) /
         ("parlour-" + std::to_string(getuid()));
}

Expected<void> make_runtime_folder(const fs::path& folder) {
  if (mkdir(folder.c_str(), S_IRWXU) != 0 && errno != EEXIST)
    return fail(ErrorKind::file,
                "the folder " + folder.string() +
                    " cannot be made: " + std::strerror(errno));
  struct stat found {};
  const bool is_own = lstat(folder.c_str(), &found) == 0 &&
                      S_ISDIR(found.st_mode) && found.st_uid == getuid() &&
                      (found.st_mode & (S_IRWXG | S_IRWXO)) == 0;
  if (!is_own)
    return fail(ErrorKind::file, folder.string() +
                                     " is not a folder of this user alone; "
                                     "remove it, or set XDG_RUNTIME_DIR");
  return {};
}

} // namespace parlour::tools
