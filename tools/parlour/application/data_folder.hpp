// DataFolder: the folder with a run's database, files, records and log. Scripts
// see its files as `data/`. A lock keeps other processes out as long as the
// object exists.
#pragma once

#include <filesystem>
#include <string>

#include "runtime/base/error.hpp"

namespace parlour::tools {

// Owned by the command that runs the node, and outlives it.
class DataFolder {
public:
  // Creates the folder if needed and locks it. Errors of kind File: it cannot
  // be created or written, or another process holds the lock.
  static Expected<DataFolder> open(const std::filesystem::path& path);

  // A new folder below the system's temporary folder (TMPDIR), without a lock.
  // The destructor removes it with everything in it.
  static Expected<DataFolder> temporary();

  DataFolder(DataFolder&& other) noexcept;
  DataFolder& operator=(DataFolder&& other) noexcept;
  // Releases the lock.
  ~DataFolder();

  // The absolute path.
  const std::filesystem::path& path() const {
    return path_;
  }

private:
  DataFolder() = default;

  std::filesystem::path path_;
  int lock_ = -1; // descriptor of the lock file
  bool temporary_ = false;
};

} // namespace parlour::tools
