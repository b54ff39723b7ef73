#include "adapters/journal/journal_part.hpp"

#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "adapters/journal/journal_format.hpp"

namespace parlour::adapters {

namespace {

tl::unexpected<Error> refused(const std::filesystem::path& path, int why) {
  return fail(ErrorKind::file, path.string() + ": " + std::strerror(why));
}

} // namespace

JournalPart::JournalPart(Descriptor file, std::filesystem::path path,
                         JournalSync sync)
    : file_(std::move(file)), path_(std::move(path)), sync_(sync) {}

Expected<JournalPart> JournalPart::make(const std::filesystem::path& path,
                                        std::uint64_t needed,
                                        JournalSync sync) {
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC,
                        S_IRUSR | S_IWUSR);
  if (file < 0)
    return refused(path, errno);
  JournalPart part(Descriptor(file), path, sync);
  if (auto begun = part.append(part_header(needed)); !begun) {
    unlink(path.c_str());
    return tl::make_unexpected(std::move(begun.error()));
  }
  return part;
}

Expected<void> JournalPart::append(std::string_view bytes) {
  auto cut = [this] {
    const int why = errno;
    static_cast<void>(ftruncate(file_.get(), static_cast<off_t>(size_)));
    static_cast<void>(lseek(file_.get(), 0, SEEK_END));
    return refused(path_, why);
  };
  for (auto rest = bytes; !rest.empty();) {
    const auto written = ::write(file_.get(), rest.data(), rest.size());
    if (written < 0 && errno == EINTR)
      continue;
    if (written < 0)
      return cut();
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
  if (sync_ == JournalSync::on_disk && fdatasync(file_.get()) != 0)
    return cut();
  size_ += bytes.size();
  return {};
}

} // namespace parlour::adapters
