// `parlour exec`: compiles a script or an application and runs its function
// `main` (script/run), without sessions, components or topics.
#include <ostream>
#include <thread>

#include "adapters/files/data_files.hpp"
#include "runtime/base/outside/file_bytes.hpp"
#include "script/run/exec_run.hpp"
#include "script/vm/listing.hpp"
#include "tools/parlour/application/application.hpp"
#include "tools/parlour/cli/commands.hpp"
#include "tools/parlour/console/exit_code.hpp"
#include "tools/parlour/console/finding_text.hpp"

namespace parlour::tools {

namespace {

// The effects of the script: prints, logs and waits in real time.
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

// "function f (file:line)", with the file relative to the working folder.
std::string shown_caller(const Places& places, const std::string& caller) {
  const auto at = caller.find(" (") + 2;
  return caller.substr(0, at) + shown_path(places, caller.substr(at));
}

// A compiled script, and the folder whose `data/` its file functions use.
struct Loaded {
  script::Compiled compiled;
  std::filesystem::path folder; // of the file, or the application
};

// A path to a file wins over an application of the same name.
Expected<Loaded> load(const Places& places, const std::string& file) {
  // If there is neither, the error names both.
  const auto path = places.working / file;
  if (is_file_like(path))
    return Loaded{load_file(path, places), path.parent_path()};
  const auto folder = find_application(places, file);
  if (!folder)
    return is_there(path)
               ? tl::make_unexpected(folder.error())
               : fail(ErrorKind::settings,
                      "there is no file or application '" + file + "'");
  return Loaded{compile_folder(*folder, find_platform(places, *folder)),
                *folder};
}

} // namespace

int exec_command(const Places& places, const ExecOptions& wanted,
                 const Console& console) {
  const auto& file = wanted.file;
  const auto loaded = load(places, file);
  if (!loaded) {
    say_error(console, loaded.error().message);
    return exit_code::usage;
  }
  const auto& compiled = loaded->compiled;
  // Warnings are printed, too; only errors leave the program null.
  print_lines(console.err, compiled.findings.all(), places);
  if (!compiled.program)
    return exit_code::wrong;
  if (wanted.listing) {
    console.out << script::listing(*compiled.program) << std::flush;
    return exit_code::success;
  }
  auto options = exec_options(console);
  options.files = adapters::data_files(loaded->folder / "data");
  const auto failure = script::run_main(compiled.program, options);
  console.out.flush();
  if (!failure)
    return exit_code::success;
  auto error = failure->error;
  if (error.place.file.empty()) // e.g. there is no function main
    error.place.file = file;
  error.place.file = shown_path(places, error.place.file);
  console.err << to_string(error) << '\n';
  // The call stack, innermost function first.
  for (const auto& caller : failure->stack)
    console.err << "  in " << shown_caller(places, caller) << '\n';
  return exit_code::wrong;
}

} // namespace parlour::tools
