// PluginFolder finds the plug-ins of a folder, each of which is a file NAME.so.
#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

// Thread-safe. Files are loaded when they are asked for. A file that has not
// changed since is not loaded again.
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
  // Whether there is a file for this name. False for a name that would lead out
  // of the folder.
  bool has(const std::string& name) const;
  // Loads the current version of the file. Errors as those of open_plugin_file.
  Expected<PluginFactory> find(const std::string& name);
  // The names of the plug-ins, sorted; none if the folder does not exist.
  std::vector<std::string> names() const;

private:
  // What distinguishes two versions of a file.
  struct Version {
    std::uint64_t device = 0;
    std::uint64_t inode = 0;
    std::int64_t size = 0;
    std::int64_t seconds = 0;
    std::int64_t nanoseconds = 0;
    bool operator==(const Version&) const = default;
  };
  // The outcome for a version, which may be an error.
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
