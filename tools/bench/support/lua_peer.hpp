// LuaPeer runs a workload with Lua, in a program of its own
// (tools/bench/lua/main.cpp) that is built if that Lua is installed. The
// program prints the time of one operation and the result.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "runtime/base/error.hpp"
#include "tools/bench/support/measure.hpp"

namespace parlour::tools {

struct LuaPeer {
  // "Lua 5.4".
  std::string title;
  // Its name in the folder of the build's programs.
  std::string program;
  std::string argument;
  // The Debian package that the build needs for it.
  std::string package;

  // Whether the program was built.
  bool is_there() const;
  // Runs the file once.
  Expected<Measured> run(const std::filesystem::path& file) const;
};

// Lua 5.4 and the interpreter of LuaJIT.
const std::vector<LuaPeer>& lua_peers();

} // namespace parlour::tools
