// JournalPart: one file of a journal, to which records are only appended.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>

#include "runtime/base/error.hpp"
#include "runtime/base/outside/descriptor.hpp"

namespace parlour::adapters {

// Whether what was written is on the disk, and outlives a loss of power, or
// with the operating system, and outlives the process.
enum class JournalSync : bool { with_system, on_disk };

class JournalPart {
public:
  // Makes the file with its header; only its owner may read it, as it has what
  // is private. Errors of kind File: it cannot be made, or is there already.
  static Expected<JournalPart> make(const std::filesystem::path& path,
                                    std::uint64_t needed, JournalSync sync);

  // All or nothing: what was written of bytes that failed is cut off again. The
  // error, of kind File, says why.
  Expected<void> append(std::string_view bytes);
  std::size_t size() const {
    return size_;
  }
  const std::filesystem::path& path() const {
    return path_;
  }

private:
  JournalPart(Descriptor file, std::filesystem::path path, JournalSync sync);

  Descriptor file_;
  std::filesystem::path path_;
  JournalSync sync_;
  std::size_t size_ = 0;
};

} // namespace parlour::adapters
