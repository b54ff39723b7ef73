// `parlour bench`: starts the program parlour-bench, which is beside this one
// if it was built (tools/bench).
#include <cerrno>
#include <cstring>

#include <unistd.h>

#include "runtime/base/outside/file_bytes.hpp"
#include "tools/parlour/cli/commands.hpp"
#include "tools/parlour/console/console.hpp"
#include "tools/parlour/console/exit_code.hpp"

namespace parlour::tools {

namespace {

// Replaces this process by the program. Returns only if that fails.
void become(const std::filesystem::path& program,
            std::vector<std::string> arguments) {
  std::vector<char*> pointers;
  for (auto& argument : arguments)
    pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  execv(program.c_str(), pointers.data());
}

} // namespace

int bench_command(const std::vector<std::string>& arguments,
                  const Places& places, const Console& console) {
  const auto program = places.programs / "parlour-bench";
  if (!is_there(program)) {
    say_error(console, "the benches are not built here; in a clone of "
                       "Parlour's sources run: tools/bench/run NAME");
    return exit_code::usage;
  }
  auto all = arguments;
  all.insert(all.begin(), program.string());
  become(program, std::move(all));
  say_error(console,
            program.string() + " cannot be started: " + std::strerror(errno));
  return exit_code::wrong;
}

} // namespace parlour::tools
