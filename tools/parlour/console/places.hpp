// Places: where applications, the platform's own files and a run's data are
// looked for (docs/running.md, "Where things are looked for").
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "runtime/base/error.hpp"

namespace parlour::tools {

struct Places {
  std::filesystem::path working; // the folder that relative paths start from
  // Folders that hold `apps` and `platform`, the first one preferred: what is
  // installed with the program; the source tree, where it is not installed.
  std::vector<std::filesystem::path> shares;
  std::function<std::optional<std::string>(const char*)> environment;
  std::filesystem::path plugins;           // as --plugins says; may be empty
  std::filesystem::path installed_plugins; // may be empty
};

// Those of the running program.
Places process_places();

// A file's name (or "file:line") as people want to read it: from the working
// folder where it lies below that, else as it is.
std::string shown_path(const Places& places, const std::string& file);

// The folder, absolute: APP itself, ./config/apps/APP, an installed one. The
// error (kind Settings) says where it was looked for.
Expected<std::filesystem::path> find_application(const Places& places,
                                                 const std::string& app);

// Whether something lies there that is no folder, even if it cannot be read:
// for commands that take one file instead of an application.
bool is_file_like(const std::filesystem::path& path);

// The platform's folder beside the application's `apps`, else a share's.
std::filesystem::path find_platform(const Places& places,
                                    const std::filesystem::path& application);

// Where plug-ins that are files are looked for, the first folder preferred: in
// what --plugins or else PARLOUR_PLUGINS names, and nowhere else; or in
// `plugins` of the application, then where they are installed.
std::vector<std::filesystem::path>
plugin_folders(const Places& places, const std::filesystem::path& application);

// Where a run of the application keeps its data unless it is told otherwise. An
// error where there is no home folder.
Expected<std::filesystem::path>
default_data_folder(const Places& places,
                    const std::filesystem::path& application);

} // namespace parlour::tools
