#include "tools/parlour/places.hpp"

#include <cstdlib>

namespace parlour::tools {

namespace fs = std::filesystem;

namespace {

std::optional<std::string> environment_variable(const char* name) {
  const auto* value = std::getenv(name);
  if (!value || !*value)
    return std::nullopt;
  return value;
}

bool is_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

bool is_file(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

bool is_bare(const std::string& app) {
  return app.find('/') == std::string::npos && app != "." && app != "..";
}

std::string absolute_text(const fs::path& path) {
  std::error_code code;
  auto canonical = fs::canonical(path, code);
  return (code ? path.lexically_normal() : canonical).string();
}

} // namespace

Places process_places() {
  std::error_code ignored;
  Places places{fs::current_path(ignored), {}, environment_variable, {}, {}};
  // bin/parlour and share/parlour lie side by side, wherever both were put.
  const auto program = fs::read_symlink("/proc/self/exe", ignored);
  const auto prefix = program.parent_path().parent_path();
  const auto beside = prefix / "share/parlour";
  places.installed_plugins = prefix / PARLOUR_PLUGIN_FOLDER;
  for (const auto& share :
       {beside, fs::path(PARLOUR_CONFIG), fs::path(PARLOUR_SHARE)})
    if (is_folder(share))
      places.shares.push_back(share);
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
  std::string looked;
  for (const auto& candidate : candidates) {
    if (!app.empty() && is_folder(candidate))
      return fs::path(absolute_text(candidate));
    looked += (looked.empty() ? "" : ", ") + candidate.string();
  }
  if (const auto file = places.working / app; is_file(file))
    return fail(ErrorKind::settings,
                "'" + app + "' is a file, and an application is a folder: " +
                    shown_path(places, file.parent_path().string()));
  return fail(ErrorKind::settings,
              "there is no application '" + app + "': looked for " + looked);
}

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

fs::path default_data_folder(const Places& places,
                             const fs::path& application) {
  fs::path data;
  if (const auto set = places.environment("XDG_DATA_HOME"))
    data = *set;
  // A relative one is to be ignored (XDG base directory specification).
  if (!data.is_absolute())
    data = fs::path(places.environment("HOME").value_or("/")) / ".local/share";
  return data / "parlour" / application.filename();
}

} // namespace parlour::tools
