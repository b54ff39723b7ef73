// A file without a place on a disk, for libraries that want the name of one.
#pragma once

#include <optional>
#include <string>

namespace parlour::adapters::asr {

// Gone with its object. Movable.
// PocketSphinx wants file names for what is made here in memory.
class MemoryFile {
public:
  // With this content, to be read from its beginning. Nothing if the system has
  // no memory for it.
  static std::optional<MemoryFile> make(const std::string& content);

  MemoryFile(MemoryFile&& other) noexcept;
  MemoryFile& operator=(MemoryFile&& other) noexcept;
  ~MemoryFile();

  int descriptor() const {
    return descriptor_;
  }
  // A path within this process.
  std::string path() const;
  // All of it.
  std::string text() const;

private:
  explicit MemoryFile(int descriptor) : descriptor_(descriptor) {}

  int descriptor_ = -1;
};

} // namespace parlour::adapters::asr
