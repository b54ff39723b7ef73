// Places: the search paths for applications, platform files, plug-ins and data
// folders (docs/running.md, "Where things are looked for").
//
// The program uses process_places(); a test fills the struct with folders of
// its own, so that nothing depends on the environment.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "runtime/base/error.hpp"
#include "runtime/base/outside/environment.hpp"

namespace parlour::tools {

struct Places {
  std::filesystem::path working; // relative paths start here
  // Folders with `apps` and `platform`, the preferred one first: the installed
  // share beside the program, or the source tree it was built from.
  std::vector<std::filesystem::path> shares;
  EnvironmentLookup environment;
  std::filesystem::path plugins;           // of --plugins; empty: not given
  std::filesystem::path installed_plugins; // empty: none
  std::filesystem::path programs;          // of the running program
};

// The search paths of the running program. Looks at the environment, the
// working folder and the program's own location.
Places process_places();

// A file's name, or "file:line", as it is shown to people: relative to the
// working folder if it lies below that, otherwise unchanged.
std::string shown_path(const Places& places, const std::string& file);

// The absolute folder of the application APP. Looks for a folder of that path,
// then for a bare name in ./config/apps and in the shares. An error of kind
// Settings lists where it looked, or says why a folder cannot be read.
Expected<std::filesystem::path> find_application(const Places& places,
                                                 const std::string& app);

// Whether the path exists and is no folder, even if it cannot be read. For
// commands that accept a script file or an application.
bool is_file_like(const std::filesystem::path& path);

// The folder of the platform's files: the `platform` beside the `apps` that
// holds the application, otherwise that of the first share.
std::filesystem::path find_platform(const Places& places,
                                    const std::filesystem::path& application);

// The folders to search for plug-in files, the preferred one first. That is
// --plugins alone if given, otherwise PARLOUR_PLUGINS alone if set, otherwise
// the application's `plugins` and the installed folder, as far as they exist.
std::vector<std::filesystem::path>
plugin_folders(const Places& places, const std::filesystem::path& application);

// The data folder of an application's runs if --data is not given, below
// XDG_DATA_HOME or ~/.local/share. An error of kind Settings if neither
// variable is set to an absolute path. Does not create the folder.
Expected<std::filesystem::path>
default_data_folder(const Places& places,
                    const std::filesystem::path& application);

} // namespace parlour::tools
