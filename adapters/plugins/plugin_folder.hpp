// PluginFolder: the plug-ins that lie in a folder, each a file NAME.so.
#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

// Safe to use from any thread. Files are opened when they are asked for; one
// that has not changed since is not opened again.
class PluginFolder {
public:
  explicit PluginFolder(std::filesystem::path folder)
      : folder_(std::move(folder)) {}

  const std::filesystem::path& path() const {
    return folder_;
  }
  std::filesystem::path file_of(const std::string& name) const {
    return folder_ / (name + ".so");
  }
  // Whether there is a file of that name; never for a name that would lead out
  // of the folder.
  bool has(const std::string& name) const;
  // The file as it is now; errors as of open_plugin_file.
  Expected<PluginFactory> find(const std::string& name);
  // Names of the files, sorted; none where the folder is missing.
  std::vector<std::string> names() const;

private:
  // What tells one version of a file from the next.
  struct Version {
    std::uint64_t device = 0;
    std::uint64_t inode = 0;
    std::int64_t size = 0;
    std::int64_t seconds = 0;
    std::int64_t nanoseconds = 0;
    bool operator==(const Version&) const = default;
  };
  struct Opened {
    Version version;
    Expected<PluginFactory> outcome;
  };

  static std::optional<Version> version_of(const std::filesystem::path& file);

  const std::filesystem::path folder_;
  std::mutex mutex_;
  std::map<std::string, Opened> opened_;
};

} // namespace parlour::adapters
