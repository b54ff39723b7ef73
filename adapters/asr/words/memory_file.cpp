#include "adapters/asr/words/memory_file.hpp"

#include <utility>

#include <sys/mman.h>
#include <unistd.h>

namespace parlour::adapters::asr {

std::optional<MemoryFile> MemoryFile::make(const std::string& content) {
  MemoryFile file(memfd_create("parlour", MFD_CLOEXEC));
  if (file.descriptor_ < 0)
    return {};
  for (std::size_t at = 0; at < content.size();) {
    const auto count =
        write(file.descriptor_, content.data() + at, content.size() - at);
    if (count <= 0)
      return {};
    at += static_cast<std::size_t>(count);
  }
  lseek(file.descriptor_, 0, SEEK_SET);
  return file;
}

MemoryFile::MemoryFile(MemoryFile&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)) {}

MemoryFile& MemoryFile::operator=(MemoryFile&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

MemoryFile::~MemoryFile() {
  if (descriptor_ >= 0)
    close(descriptor_);
}

// Valid in this process alone: another one would find its own descriptor there.
std::string MemoryFile::path() const {
  return "/proc/self/fd/" + std::to_string(descriptor_);
}

std::string MemoryFile::text() const {
  std::string text;
  char buffer[4096];
  ssize_t count = 0;
  while ((count = pread(descriptor_, buffer, sizeof buffer,
                        static_cast<off_t>(text.size()))) > 0)
    text.append(buffer, static_cast<std::size_t>(count));
  return text;
}

} // namespace parlour::adapters::asr
