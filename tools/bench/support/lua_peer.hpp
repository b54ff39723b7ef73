// A Lua that does the same work as a script of ours, in a program of its own
// (lua/main.cpp), which the build makes where it finds that Lua.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "runtime/base/error.hpp"
#include "tools/bench/support/measure.hpp"

namespace parlour::tools {

struct LuaPeer {
  std::string title;   // "Lua 5.4"
  std::string program; // in the folder of the build's programs
  std::string argument;
  std::string package; // the Debian package that the build wants for it

  bool is_there() const;
  // Runs `file` once.
  Expected<Measured> run(const std::filesystem::path& file) const;
};

// Lua 5.4 and LuaJIT's interpreter.
const std::vector<LuaPeer>& lua_peers();

} // namespace parlour::tools
