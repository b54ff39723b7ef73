// The commands `parlour plugin list|roles|new|test`. They follow the rules of
// commands.hpp.
#pragma once

#include <string>
#include <vector>

#include "runtime/base/clock.hpp"
#include "tools/parlour/console/console.hpp"
#include "tools/parlour/console/places.hpp"

namespace parlour::tools {

// `parlour plugin list`: prints every plug-in with its roles, options, commands
// and events: those of the program, then those in the plug-in folders (Places,
// plugin_folders) of `app`, or of the working folder if `app` is empty. A file
// that cannot be loaded is an error; the others are listed all the same.
int plugin_list_command(const Places& places, const std::string& app,
                        const Console& console);

// `parlour plugin roles`: prints the commands and events of a role, or one line
// for each role if `name` is empty.
int plugin_roles_command(const std::string& name, const Console& console);

// `parlour plugin new`: writes the files of a new plug-in (plugin_template).
// Never overwrites a file.
struct NewPluginOptions {
  std::string name;   // its class, such as EchoTTS
  std::string role;   // a role or its alias
  std::string folder; // empty: ./NAME
};
int plugin_new_command(const Places& places, const NewPluginOptions& options,
                       const Console& console);

// `parlour plugin test`: runs the conformance test of the plug-in's roles
// (runtime/plugin/conformance.hpp).
struct TestPluginOptions {
  std::string plugin;               // a file NAME.so, or a plug-in's name
  std::vector<std::string> options; // "name=value"
  // How long after its start it may load what it needs, such as a model: until
  // then, an answer may take longer.
  Milliseconds load_time{15'000};
};
// The test runs in a child process, so a plug-in may crash or hang.
int plugin_test_command(const Places& places, const TestPluginOptions& options,
                        const Console& console);

} // namespace parlour::tools
