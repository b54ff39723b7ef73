#include <ostream>
#include <thread>

#include "script/exec_host.hpp"
#include "tools/parlour/application.hpp"
#include "tools/parlour/commands.hpp"
#include "tools/parlour/exit_code.hpp"
#include "tools/parlour/finding_text.hpp"

namespace parlour::tools {

namespace {

script::ExecOptions exec_options(const Console& console) {
  script::ExecOptions options;
  options.print = [&](std::string_view text) { console.out << text << '\n'; };
  options.log = [&](std::string_view text) {
    console.err << text << std::endl;
  };
  options.now = [] { return SystemClock().now(); };
  options.wait_until = [](Timestamp due) {
    std::this_thread::sleep_for(Milliseconds(due - SystemClock().now()));
  };
  return options;
}

// "function f (file:line)" with the file as people want to read it.
std::string shown_caller(const Places& places, const std::string& caller) {
  const auto at = caller.find(" (") + 2;
  return caller.substr(0, at) + shown_path(places, caller.substr(at));
}

Expected<script::Compiled> compile(const Places& places,
                                   const std::string& file) {
  std::error_code ignored;
  const auto path = places.working / file;
  if (std::filesystem::is_regular_file(path, ignored))
    return load_file(path, places);
  const auto folder = find_application(places, file);
  if (!folder)
    return fail(ErrorKind::settings,
                "there is no file or application '" + file + "'");
  return compile_folder(*folder, find_platform(places, *folder));
}

} // namespace

int exec_command(const Places& places, const std::string& file,
                 const Console& console) {
  const auto compiled = compile(places, file);
  if (!compiled) {
    say_error(console, compiled.error().message);
    return exit_code::usage;
  }
  print_lines(console.err, compiled->findings.all(), places);
  if (!compiled->program)
    return exit_code::wrong;
  const auto failure =
      script::run_main(compiled->program, exec_options(console));
  console.out.flush();
  if (!failure)
    return exit_code::well;
  auto error = failure->error;
  error.place.file = shown_path(places, error.place.file);
  console.err << to_string(error) << '\n';
  for (const auto& caller : failure->stack)
    console.err << "  in " << shown_caller(places, caller) << '\n';
  return exit_code::wrong;
}

} // namespace parlour::tools
