// Search paths. docs/running.md tells users the same rules.
#include "tools/parlour/console/places.hpp"

#include <cerrno>
#include <cstring>

#include <unistd.h>

#include "runtime/base/outside/environment.hpp"
#include "runtime/base/outside/file_bytes.hpp"

namespace parlour::tools {

namespace fs = std::filesystem;

namespace {

bool is_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

// Why an existing path cannot be read as an application; empty if it can, or if
// nothing is there.
std::string trouble_with(const fs::path& path) {
  std::error_code failed;
  const auto status = fs::status(path, failed);
  if (status.type() == fs::file_type::not_found)
    return "";
  if (failed)
    return failed.message();
  return fs::is_directory(status) && access(path.c_str(), R_OK | X_OK) != 0
             ? std::strerror(errno)
             : "";
}

// A bare name is also looked up in the known folders; a path is not.
bool is_bare(const std::string& app) {
  return app.find('/') == std::string::npos && app != "." && app != "..";
}

// The path with links and ".." resolved, so that messages and locks name a
// folder in one way.
std::string absolute_text(const fs::path& path) {
  std::error_code code;
  auto canonical = fs::canonical(path, code);
  return (code ? path.lexically_normal() : canonical).string();
}

} // namespace

Places process_places() {
  std::error_code ignored;
  Places places{
      fs::current_path(ignored), {}, environment_variable, {}, {}, {}};
  // An installed program: bin/parlour and share/parlour have the same parent,
  // wherever that is. PARLOUR_CONFIG is the source tree, PARLOUR_SHARE the
  // configured prefix.
  const auto program = fs::read_symlink("/proc/self/exe", ignored);
  places.programs = program.parent_path();
  const auto prefix = places.programs.parent_path();
  const auto beside = prefix / "share/parlour";
  places.installed_plugins = prefix / PARLOUR_PLUGIN_FOLDER;
  for (const auto& share :
       {beside, fs::path(PARLOUR_CONFIG), fs::path(PARLOUR_SHARE)})
    if (is_folder(share / "platform")) {
      places.shares.push_back(share);
      break;
    }
  return places;
}

std::string shown_path(const Places& places, const std::string& file) {
  const auto folder = places.working.string() + '/';
  return file.rfind(folder, 0) == 0 ? file.substr(folder.size()) : file;
}

Expected<fs::path> find_application(const Places& places,
                                    const std::string& app) {
  std::vector<fs::path> candidates{places.working / app};
  if (is_bare(app)) {
    candidates.push_back(places.working / "config/apps" / app);
    for (const auto& share : places.shares)
      candidates.push_back(share / "apps" / app);
  }
  // The first readable folder wins. A candidate that exists and cannot be read
  // is an error, not skipped: another application of the name would surprise.
  std::string looked;
  for (const auto& candidate : candidates) {
    if (const auto why = trouble_with(candidate); !why.empty())
      return fail(ErrorKind::settings, "the application " + candidate.string() +
                                           " cannot be read: " + why);
    if (!app.empty() && is_folder(candidate))
      return fs::path(absolute_text(candidate));
    looked += (looked.empty() ? "" : ", ") + candidate.string();
  }
  // Somebody named a file inside of an application: suggest its folder.
  if (const auto file = places.working / app; !app.empty() && is_there(file))
    return fail(ErrorKind::settings,
                "'" + app + "' is no folder, and an application is a folder: " +
                    shown_path(places, file.parent_path().string()));
  return fail(ErrorKind::settings,
              "there is no application '" + app + "': looked for " + looked);
}

bool is_file_like(const fs::path& path) {
  return path.has_filename() && is_there(path) && !is_folder(path);
}

// An application in a tree of `apps` and `platform` uses the platform's files
// of that tree, so that a source tree does not depend on what is installed.
fs::path find_platform(const Places& places, const fs::path& application) {
  const auto apps = application.parent_path();
  if (apps.filename() == "apps" && is_folder(apps.parent_path() / "platform"))
    return apps.parent_path() / "platform";
  for (const auto& share : places.shares)
    if (is_folder(share / "platform"))
      return share / "platform";
  return fs::path(PARLOUR_SHARE) / "platform";
}

std::vector<fs::path> plugin_folders(const Places& places,
                                     const fs::path& application) {
  if (!places.plugins.empty())
    return {places.working / places.plugins};
  if (const auto set = places.environment("PARLOUR_PLUGINS"))
    return {places.working / *set};
  std::vector<fs::path> folders;
  for (const auto& folder : {application / "plugins", places.installed_plugins})
    if (is_folder(folder))
      folders.push_back(folder);
  return folders;
}

Expected<fs::path> default_data_folder(const Places& places,
                                       const fs::path& application) {
  const auto data =
      user_folder(places.environment, "XDG_DATA_HOME", ".local/share");
  if (data.empty())
    return fail(ErrorKind::settings,
                "there is no home folder for the data of a run (HOME); --data "
                "names a folder");
  return data / "parlour" / application.filename();
}

} // namespace parlour::tools
