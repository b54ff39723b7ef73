// The lock is flock() on the file `.lock` in the folder. The kernel releases it
// when the process ends in any way, so a stale file does no harm.
#include "tools/parlour/application/data_folder.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace parlour::tools {

namespace fs = std::filesystem;

namespace {

constexpr const char* another = "; --data names another";

tl::unexpected<Error> trouble(const fs::path& path, const std::string& why) {
  return fail(ErrorKind::file, "the data folder " + path.string() + ' ' + why);
}

// " (process 123)" as the holder of the lock wrote it, or empty.
std::string holder(int lock) {
  char text[32] = {};
  const auto size = pread(lock, text, sizeof text - 1, 0);
  const auto number = size > 0 ? std::atol(text) : 0;
  return number > 0 ? " (process " + std::to_string(number) + ")" : "";
}

// Writes our process id into the lock file.
void write_holder(int lock) {
  const auto text = std::to_string(getpid()) + "\n";
  // Only for people to read; the lock itself is flock's.
  if (ftruncate(lock, 0) == 0)
    (void)!pwrite(lock, text.data(), text.size(), 0);
}

} // namespace

Expected<DataFolder> DataFolder::open(const fs::path& path) {
  DataFolder folder;
  std::error_code code;
  fs::create_directories(path, code);
  if (code)
    return trouble(path, "cannot be made: " + code.message() + another);
  // The path without links: two names of one folder share one lock.
  folder.path_ = fs::canonical(path, code);
  if (code)
    return trouble(path, "cannot be found: " + code.message());
  folder.lock_ = ::open((folder.path_ / ".lock").c_str(),
                        O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (folder.lock_ < 0)
    return trouble(path, std::string("cannot be written: ") +
                             std::strerror(errno) + another);
  // Do not wait: the other process may run for days.
  if (flock(folder.lock_, LOCK_EX | LOCK_NB) != 0)
    return trouble(path, "is in use by another parlour" + holder(folder.lock_) +
                             "; end that one, or choose another folder with "
                             "--data");
  write_holder(folder.lock_);
  return folder;
}

Expected<DataFolder> DataFolder::temporary() {
  std::error_code code;
  auto pattern = (fs::temp_directory_path(code) / "parlour-XXXXXX").string();
  if (!code && !mkdtemp(pattern.data()))
    code.assign(errno, std::generic_category());
  if (code)
    return fail(ErrorKind::file, "no temporary folder can be made (TMPDIR "
                                 "says where): " +
                                     code.message());
  DataFolder folder;
  folder.path_ = pattern;
  folder.temporary_ = true;
  return folder;
}

// The moved-from object releases nothing.
DataFolder::DataFolder(DataFolder&& other) noexcept
    : path_(std::move(other.path_)), lock_(std::exchange(other.lock_, -1)),
      temporary_(std::exchange(other.temporary_, false)) {}

// Swaps, so that the destructor of `other` cleans up what this one held.
DataFolder& DataFolder::operator=(DataFolder&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(lock_, other.lock_);
  std::swap(temporary_, other.temporary_);
  return *this;
}

DataFolder::~DataFolder() {
  if (lock_ >= 0)
    close(lock_);
  std::error_code ignored;
  if (temporary_)
    fs::remove_all(path_, ignored);
}

} // namespace parlour::tools
