// `parlour component`: the child process of a component with host="process". It
// finds the plug-in's factory and hands control to adapters/process.
#include <sys/prctl.h>
#include <sys/stat.h>

#include "adapters/process/child_process.hpp"
#include "adapters/process/component_server.hpp"
#include "script/source/findings.hpp"
#include "tools/parlour/application/plugins/catalogue.hpp"
#include "tools/parlour/cli/commands.hpp"
#include "tools/parlour/console/exit_code.hpp"

namespace parlour::tools {

namespace {

// The parent opens a socket at a fixed descriptor before it starts us. Without
// it, somebody has typed the command by hand.
bool is_socket(int descriptor) {
  struct stat status {};
  return fstat(descriptor, &status) == 0 && S_ISSOCK(status.st_mode);
}

} // namespace

int component_command(const ComponentOptions& options, const Console& console) {
  constexpr auto socket = adapters::component_socket;
  if (!is_socket(socket)) {
    say_error(console, "parlour starts this by itself for a component with "
                       "host=\"process\"");
    return exit_code::usage;
  }
  // Name the process: without this, ps would show "exe" for the link
  // /proc/self/exe that started it.
  prctl(PR_SET_NAME, "parlour");
  std::vector<std::filesystem::path> folders;
  if (!options.folder.empty())
    folders.emplace_back(options.folder);
  // If there is no such plug-in, tell the parent why instead of serving it.
  const auto factory = Catalogue(folders).find(options.plugin);
  return factory ? adapters::serve_component(socket, *factory)
                 : adapters::refuse_component(socket, factory.error());
}

} // namespace parlour::tools
