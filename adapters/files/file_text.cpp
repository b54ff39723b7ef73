#include "adapters/files/file_text.hpp"

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "adapters/files/encoding.hpp"

namespace parlour::adapters {

namespace {

// How much is read at once.
constexpr std::size_t piece = 64 << 10;

tl::unexpected<Error> too_large(std::size_t max_bytes) {
  return fail(ErrorKind::file, "it would have more than " +
                                   std::to_string(max_bytes) +
                                   " bytes; <limits result> allows more");
}

// write() may take a part only, or be interrupted by a signal.
Expected<void> write_all(int file, std::string_view text) {
  while (!text.empty()) {
    const auto written = write(file, text.data(), text.size());
    if (written < 0 && errno == EINTR)
      continue;
    if (written < 0)
      return system_trouble("it cannot be written");
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return {};
}

// Waits until the disk has the data.
Expected<void> to_disk(int file) {
  if (fsync(file) != 0)
    return system_trouble("it cannot be brought to the disk");
  return {};
}

// Unique within the process by a counter, and among running processes by the
// process id. The leading dot hides it from scripts.
std::string temporary_name() {
  static std::atomic<std::uint64_t> last = 0;
  return ".parlour-" + std::to_string(getpid()) + "-" + std::to_string(++last) +
         ".new";
}

// A temporary file that takes the place of another one. It is removed if that
// fails.
class Replacement {
public:
  explicit Replacement(const Folder& folder)
      : folder_(folder), name_(temporary_name()) {}
  Replacement(const Replacement&) = delete;
  Replacement& operator=(const Replacement&) = delete;
  ~Replacement() {
    if (!placed_)
      unlinkat(folder_.get(), name_.c_str(), 0);
  }

  Expected<void> write(std::string_view text) {
    // A process with the same id may have been killed and have left its file.
    unlinkat(folder_.get(), name_.c_str(), 0);
    auto file = folder_.file(name_, O_WRONLY | O_CREAT | O_EXCL);
    if (!file)
      return tl::make_unexpected(file.error());
    if (auto written = write_all(file->get(), text); !written)
      return written;
    return to_disk(file->get());
  }

  Expected<void> take_place_of(const std::string& name) {
    if (renameat(folder_.get(), name_.c_str(), folder_.get(), name.c_str()) !=
        0)
      return system_trouble("it cannot be put in place");
    placed_ = true;
    // The new entry of the folder must survive a loss of power, too.
    return to_disk(folder_.get());
  }

private:
  const Folder& folder_;
  const std::string name_;
  bool placed_ = false;
};

} // namespace

Expected<std::string> read_text(const Folder& folder, const std::string& name,
                                std::size_t max_bytes) {
  const auto file = folder.file(name, O_RDONLY);
  if (!file)
    return tl::make_unexpected(file.error());
  std::string text;
  // Grows the text by one piece at a time: the size that the system reports may
  // change while the file is read.
  for (;;) {
    const auto size = text.size();
    text.resize(size + piece);
    const auto got = read(file->get(), text.data() + size, piece);
    text.resize(size + static_cast<std::size_t>(got > 0 ? got : 0));
    if (got < 0 && errno != EINTR)
      return system_trouble("it cannot be read");
    if (text.size() > max_bytes)
      return fail(ErrorKind::file, "it has more than " +
                                       std::to_string(max_bytes) +
                                       " bytes; <limits result> allows more");
    if (got == 0)
      break;
  }
  if (!is_utf8(text))
    return fail(ErrorKind::file, "it is not text in UTF-8");
  return text;
}

Expected<void> write_text(const Folder& folder, const std::string& name,
                          std::string_view text, std::size_t max_bytes) {
  if (text.size() > max_bytes)
    return too_large(max_bytes);
  // rename() would replace a link or a pipe as well, so they are refused first.
  const auto what = folder.what(name);
  if (what == Folder::What::folder || what == Folder::What::other)
    return fail(ErrorKind::file, what == Folder::What::folder
                                     ? "there is a folder of this name"
                                     : "it is a link, or no regular file");
  Replacement replacement(folder);
  if (auto written = replacement.write(text); !written)
    return written;
  return replacement.take_place_of(name);
}

Expected<void> append_text(const Folder& folder, const std::string& name,
                           std::string_view text, std::size_t max_bytes) {
  if (text.size() > max_bytes)
    return too_large(max_bytes);
  const auto file = folder.file(name, O_WRONLY | O_APPEND | O_CREAT);
  if (!file)
    return tl::make_unexpected(file.error());
  // flock() may be interrupted by a signal.
  while (flock(file->get(), LOCK_EX) != 0)
    if (errno != EINTR)
      return system_trouble("it cannot be held");
  // The size cannot change any more while the lock is held.
  const auto size = lseek(file->get(), 0, SEEK_END);
  if (size < 0)
    return system_trouble("it cannot be written");
  if (static_cast<std::size_t>(size) + text.size() > max_bytes)
    return too_large(max_bytes);
  auto written = write_all(file->get(), text);
  // A full disk may have taken a part of the text.
  if (!written)
    (void)!ftruncate(file->get(), size);
  return written ? to_disk(file->get()) : written;
}

Expected<void> remove_file(const Folder& folder, const std::string& name) {
  const auto what = folder.what(name);
  if (what == Folder::What::folder)
    return fail(ErrorKind::file, "it is a folder");
  if (what == Folder::What::other)
    return fail(ErrorKind::file, "it is a link, or no regular file");
  if (unlinkat(folder.get(), name.c_str(), 0) != 0)
    return system_trouble("it cannot be deleted");
  return {};
}

} // namespace parlour::adapters
