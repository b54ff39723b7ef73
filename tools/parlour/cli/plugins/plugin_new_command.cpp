// `parlour plugin new`: writes the files of plugin_template to a folder.
#include <cerrno>
#include <cstring>
#include <fstream>
#include <ostream>

#include "tools/parlour/cli/plugins/plugin_commands.hpp"
#include "tools/parlour/console/exit_code.hpp"
#include "tools/parlour/plugin_template/plugin_skeleton.hpp"

namespace parlour::tools {

namespace {

namespace fs = std::filesystem;

// Checks that none of the files exists before it writes the first one, so that
// a refused command leaves nothing behind.
Expected<void> write_files(const fs::path& folder,
                           const std::vector<SkeletonFile>& files) {
  std::error_code code;
  fs::create_directories(folder, code);
  if (code)
    return fail(ErrorKind::file, "cannot make the folder " + folder.string() +
                                     ": " + code.message());
  for (const auto& file : files)
    if (fs::exists(folder / file.name, code))
      return fail(ErrorKind::file, (folder / file.name).string() +
                                       " is there already; --folder names "
                                       "another");
  for (const auto& file : files)
    if (!(std::ofstream(folder / file.name, std::ios::binary)
          << file.text << std::flush))
      return fail(ErrorKind::file, "cannot write " +
                                       (folder / file.name).string() + ": " +
                                       std::strerror(errno));
  return {};
}

} // namespace

int plugin_new_command(const Places& places, const NewPluginOptions& options,
                       const Console& console) {
  const auto files = plugin_skeleton(options.name, options.role);
  if (!files) {
    say_error(console, files.error().message);
    return exit_code::usage;
  }
  const auto folder =
      places.working / (options.folder.empty() ? options.name : options.folder);
  if (const auto written = write_files(folder, *files); !written) {
    say_error(console, written.error().message);
    return exit_code::wrong;
  }
  for (const auto& file : *files)
    console.out << shown_path(places, (folder / file.name).string()) << '\n';
  return exit_code::success;
}

} // namespace parlour::tools
