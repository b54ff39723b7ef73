#include "runtime/base/outside/file_bytes.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "runtime/base/outside/descriptor.hpp"

namespace parlour {

namespace {

namespace fs = std::filesystem;

tl::unexpected<Error> unusable(const fs::path& path, std::string message) {
  return fail(ErrorKind::file, std::move(message), {path.string(), 0, 0});
}

tl::unexpected<Error> unreadable(const fs::path& path) {
  return unusable(path, std::string("this file cannot be read: ") +
                            std::strerror(errno));
}

// The kind of a path that is not a regular file, in words.
const char* name_of_kind(mode_t mode) {
  switch (mode & S_IFMT) {
  case S_IFDIR:
    return "folder";
  case S_IFIFO:
    return "named pipe";
  case S_IFSOCK:
    return "socket";
  default:
    return "device";
  }
}

Expected<void> check_kind(const fs::path& path, const struct stat& status) {
  if (S_ISREG(status.st_mode))
    return {};
  return unusable(path, std::string("this is a ") +
                            name_of_kind(status.st_mode) + ", not a file");
}

// O_NONBLOCK: the file may have been replaced by a pipe since it was checked,
// and opening a pipe without a writer would block.
Descriptor open_to_read(const fs::path& path) {
  return Descriptor(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
}

// Appends the next part to `bytes`, up to `most` bytes in all. Returns its
// size; 0 at the end; -1 and errno for an error.
ssize_t read_part(int descriptor, std::string& bytes, std::size_t most) {
  constexpr std::size_t part = 64 << 10;
  const auto before = bytes.size();
  bytes.resize(before + std::min(part, most - before));
  ssize_t size = 0;
  do
    size = read(descriptor, bytes.data() + before, bytes.size() - before);
  while (size < 0 && errno == EINTR);
  bytes.resize(before + static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
  return size;
}

} // namespace

Expected<void> check_is_file(const fs::path& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0)
    return unreadable(path);
  return check_kind(path, status);
}

Expected<void> check_may_be_file(const fs::path& path) {
  return is_there(path) ? check_is_file(path) : Expected<void>();
}

Expected<std::string> read_file(const fs::path& path, std::size_t most) {
  if (auto file = check_is_file(path); !file)
    return tl::make_unexpected(file.error());
  // The file is checked again after it was opened: only what the descriptor
  // refers to is certain not to change.
  const auto descriptor = open_to_read(path);
  struct stat status {};
  if (!descriptor || fstat(descriptor.get(), &status) != 0)
    return unreadable(path);
  if (auto file = check_kind(path, status); !file)
    return tl::make_unexpected(file.error());
  // Reads until the end rather than by the size that fstat reports, as the file
  // may grow meanwhile. One byte more than allowed shows that it is too large.
  std::string bytes;
  while (bytes.size() <= most) {
    const auto size = read_part(descriptor.get(), bytes, most + 1);
    if (size < 0)
      return unreadable(path);
    if (size == 0)
      return bytes;
  }
  return unusable(path, "this file is larger than " +
                            std::to_string(most >> 20) + " MB");
}

// Sorted, so that the result does not depend on the file system.
Expected<std::vector<fs::path>> list_files(const fs::path& folder,
                                           const std::string& extension) {
  std::vector<fs::path> paths;
  std::error_code failed;
  for (fs::directory_iterator entry(folder, failed), end;
       !failed && entry != end; entry.increment(failed))
    if (const auto name = entry->path().filename();
        name.extension() == extension && !name.string().starts_with('.'))
      paths.push_back(entry->path());
  if (failed)
    return unusable(folder, "this folder cannot be read: " + failed.message());
  std::sort(paths.begin(), paths.end());
  return paths;
}

bool is_there(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(fs::symlink_status(path, ignored));
}

} // namespace parlour
