// Runs one workload with Lua 5.4 or LuaJIT:
//
//  bench_lua5.4 FILE [--interpreter]
//
// The file returns a function. The function returns the number of operations
// and a result. Prints the nanoseconds of CPU time for one operation, and the
// result.
#include <cstdio>
#include <cstring>
#include <ctime>

#include <lua.hpp>
#ifdef LUAJIT_VERSION
#include <luajit.h>
#endif

namespace {

// The native function that the workload `builtin` calls.
int larger(lua_State* state) {
  const auto a = lua_tonumber(state, 1);
  const auto b = lua_tonumber(state, 2);
  lua_pushnumber(state, a > b ? a : b);
  return 1;
}

double seconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) +
         static_cast<double>(time.tv_nsec) * 1e-9;
}

// Loading the file is not measured.
bool run(lua_State* state, const char* file) {
  if (luaL_loadfile(state, file) || lua_pcall(state, 0, 1, 0))
    return false;
  const auto start = seconds();
  if (lua_pcall(state, 0, 2, 0))
    return false;
  const auto spent = seconds() - start;
  std::printf("%.3f ", spent * 1e9 / lua_tonumber(state, -2));
  if (lua_type(state, -1) == LUA_TSTRING)
    std::printf("%s\n", lua_tostring(state, -1));
  else
    std::printf("%.14g\n", lua_tonumber(state, -1));
  return true;
}

} // namespace

int main(int count, char** arguments) {
  if (count < 2)
    return 2;
  auto* state = luaL_newstate();
  luaL_openlibs(state);
  lua_register(state, "larger", larger);
#ifdef LUAJIT_VERSION
  if (count > 2 && std::strcmp(arguments[2], "--interpreter") == 0)
    luaJIT_setmode(state, 0, LUAJIT_MODE_ENGINE | LUAJIT_MODE_OFF);
#endif
  const bool ok = run(state, arguments[1]);
  if (!ok)
    std::fprintf(stderr, "%s\n", lua_tostring(state, -1));
  lua_close(state);
  return ok ? 0 : 1;
}
