// Uses the *at functions of POSIX, which take a name relative to an open
// folder. The kernel resolves a single part at a time, so no link can redirect
// the rest of a path.
#include "adapters/files/folder.hpp"

#include <cerrno>
#include <memory>
#include <system_error>
#include <utility>
#include <vector>

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace parlour::adapters {

namespace {

// O_NOFOLLOW makes open() fail for a link.
constexpr int folder_flags = O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC;
constexpr mode_t folder_mode = 0755;
constexpr mode_t file_mode = 0644;

// Translates the errors that O_NOFOLLOW and O_DIRECTORY cause.
tl::unexpected<Error> not_opened(const std::string& name) {
  switch (errno) {
  case ELOOP:
  case EMLINK:
    return fail(ErrorKind::file, "'" + name + "' is a link; those are refused");
  case ENOTDIR:
    return fail(ErrorKind::file, "'" + name + "' is no folder, or a link");
  case EISDIR:
    return fail(ErrorKind::file, "'" + name + "' is a folder");
  case ENXIO:
    return fail(ErrorKind::file, "'" + name + "' is no regular file");
  default:
    return system_trouble("'" + name + "'");
  }
}

} // namespace

tl::unexpected<Error> system_trouble(const std::string& what) {
  return fail(ErrorKind::file,
              what + ": " + std::generic_category().message(errno));
}

Expected<Folder> Folder::open(const std::filesystem::path& path,
                              Missing missing) {
  if (missing == Missing::make && mkdir(path.c_str(), folder_mode) != 0 &&
      errno != EEXIST)
    return not_opened(path.filename().string());
  Descriptor descriptor(::open(path.c_str(), folder_flags));
  if (!descriptor)
    return not_opened(path.filename().string());
  return Folder(std::move(descriptor));
}

Expected<Folder> Folder::folder(const std::string& name,
                                Missing missing) const {
  if (missing == Missing::make &&
      mkdirat(get(), name.c_str(), folder_mode) != 0 && errno != EEXIST)
    return not_opened(name);
  Descriptor descriptor(openat(get(), name.c_str(), folder_flags));
  if (!descriptor)
    return not_opened(name);
  return Folder(std::move(descriptor));
}

// O_NONBLOCK keeps open() from waiting for the other end of a pipe, and
// O_NOCTTY from taking over a terminal. The kind of the file is checked
// afterwards, on the descriptor, so that it cannot be exchanged in between.
Expected<Descriptor> Folder::file(const std::string& name, int flags) const {
  Descriptor descriptor(openat(
      get(), name.c_str(),
      flags | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC, file_mode));
  if (!descriptor)
    return not_opened(name);
  struct stat found {};
  if (fstat(descriptor.get(), &found) != 0)
    return not_opened(name);
  if (S_ISDIR(found.st_mode))
    return fail(ErrorKind::file, "'" + name + "' is a folder");
  if (!S_ISREG(found.st_mode))
    return fail(ErrorKind::file, "'" + name + "' is no regular file");
  // A hard link may be another name of a file outside of the data folder.
  if (found.st_nlink > 1)
    return fail(ErrorKind::file, "'" + name +
                                     "' is a link: the file has other names, "
                                     "maybe outside of the data folder");
  return descriptor;
}

Expected<std::vector<std::string>> Folder::names(std::size_t most) const {
  // A new descriptor for the same folder, since reading entries moves its
  // position.
  Descriptor again(openat(get(), ".", folder_flags));
  std::unique_ptr<DIR, int (*)(DIR*)> entries(
      again ? fdopendir(again.get()) : nullptr, &closedir);
  if (!entries)
    return system_trouble("the folder");
  // closedir closes the descriptor.
  again.release();
  std::vector<std::string> names;
  while (const auto* entry = readdir(entries.get())) {
    if (names.size() >= most)
      return fail(ErrorKind::file, "there are too many files to list");
    names.emplace_back(entry->d_name);
  }
  return names;
}

Folder::What Folder::what(const std::string& name) const {
  struct stat found {};
  if (fstatat(get(), name.c_str(), &found, AT_SYMLINK_NOFOLLOW) != 0)
    return What::nothing;
  return S_ISREG(found.st_mode)   ? What::file
         : S_ISDIR(found.st_mode) ? What::folder
                                  : What::other;
}

} // namespace parlour::adapters
