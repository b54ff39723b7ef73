#include "tools/bench/support/lua_peer.hpp"

#include <array>
#include <cstdio>
#include <memory>
#include <sstream>

namespace parlour::tools {

namespace {

std::filesystem::path path_of(const LuaPeer& peer) {
  return std::filesystem::path(PARLOUR_PROGRAMS) / peer.program;
}

std::string quoted(const std::string& text) {
  return "'" + text + "'";
}

// Runs a shell command and returns what it prints.
std::string output_of(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"),
                                                   pclose);
  std::string output;
  std::array<char, 256> part{};
  while (pipe && std::fgets(part.data(), part.size(), pipe.get()))
    output += part.data();
  return output;
}

} // namespace

bool LuaPeer::is_there() const {
  std::error_code ignored;
  return std::filesystem::exists(path_of(*this), ignored);
}

Expected<Measured> LuaPeer::run(const std::filesystem::path& file) const {
  std::istringstream output(output_of(quoted(path_of(*this).string()) + " " +
                                      quoted(file.string()) + " " + argument));
  Measured measured;
  // The program prints the time and the result.
  if (!(output >> measured.nanoseconds >> measured.result))
    return fail(ErrorKind::file, title + " cannot run " + file.string());
  return measured;
}

const std::vector<LuaPeer>& lua_peers() {
  static const std::vector<LuaPeer> peers{
      {"Lua 5.4", "bench_lua5.4", "", "liblua5.4-dev"},
      {"LuaJIT interpreter", "bench_luajit", "--interpreter",
       "libluajit-5.1-dev"}};
  return peers;
}

} // namespace parlour::tools
