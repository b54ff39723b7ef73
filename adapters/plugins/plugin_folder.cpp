#include "adapters/plugins/plugin_folder.hpp"

#include <algorithm>
#include <cctype>

#include <sys/stat.h>

#include "adapters/plugins/plugin_file.hpp"

namespace parlour::adapters {

namespace fs = std::filesystem;

namespace {

// No slash, so that a name cannot lead out of the folder.
bool is_name(const std::string& name) {
  return !name.empty() && name.front() != '.' &&
         std::ranges::all_of(name, [](unsigned char c) {
           return std::isalnum(c) || c == '_' || c == '-' || c == '.';
         });
}

} // namespace

// A replaced file differs in its inode, a changed one in size or time.
std::optional<PluginFolder::Version>
PluginFolder::version_of(const fs::path& file) {
  struct stat seen {};
  if (stat(file.c_str(), &seen) != 0)
    return std::nullopt;
  return Version{seen.st_dev, seen.st_ino, seen.st_size, seen.st_mtim.tv_sec,
                 seen.st_mtim.tv_nsec};
}

bool PluginFolder::has(const std::string& name) const {
  std::error_code ignored;
  return is_name(name) && fs::is_regular_file(file_of(name), ignored);
}

Expected<PluginFactory> PluginFolder::find(const std::string& name) {
  if (!is_name(name))
    return fail(ErrorKind::settings,
                "'" + name +
                    "' is no name of a plug-in; it is the name of a "
                    "file in " +
                    folder_.string() + " without '.so'");
  const auto file = file_of(name);
  std::lock_guard lock(mutex_);
  // Under the lock, so that two threads do not load the same version twice. A
  // missing file is not remembered: it may come.
  const auto now = version_of(file);
  auto known = opened_.find(name);
  if (now && known != opened_.end() && known->second.version == *now)
    return known->second.outcome;
  auto outcome = open_plugin_file(file);
  if (now)
    opened_.insert_or_assign(name, Opened{*now, outcome});
  return outcome;
}

std::vector<std::string> PluginFolder::names() const {
  std::vector<std::string> names;
  std::error_code code;
  // A missing folder gives an error code and thus no names.
  for (fs::directory_iterator entry(folder_, code), end; !code && entry != end;
       entry.increment(code))
    if (entry->path().extension() == ".so" && has(entry->path().stem()))
      names.push_back(entry->path().stem());
  std::ranges::sort(names);
  return names;
}

} // namespace parlour::adapters
