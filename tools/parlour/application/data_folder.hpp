// DataFolder: the folder that a run keeps its database, files and records in.
// Held by one process at a time; what scripts see as `data/`.
#pragma once

#include <filesystem>
#include <string>

#include "runtime/base/error.hpp"

namespace parlour::tools {

class DataFolder {
public:
  // Makes the folder and takes its lock. Errors (kind File): it cannot be
  // made or written, or another process holds it.
  static Expected<DataFolder> open(const std::filesystem::path& path);

  // A folder of its own below the system's for temporary files, removed with
  // all that is in it when this goes.
  static Expected<DataFolder> temporary();

  DataFolder(DataFolder&& other) noexcept;
  DataFolder& operator=(DataFolder&& other) noexcept;
  ~DataFolder();

  // Absolute.
  const std::filesystem::path& path() const {
    return path_;
  }

private:
  DataFolder() = default;

  std::filesystem::path path_;
  int lock_ = -1;
  bool temporary_ = false;
};

} // namespace parlour::tools
