// See opening.hpp.
#include "tools/parlour/application/opening.hpp"

#include "tools/parlour/console/exit_code.hpp"
#include "tools/parlour/console/finding_text.hpp"

namespace parlour::tools {

std::variant<Application, int> open_application(const Places& places,
                                                const std::string& app,
                                                const Console& console,
                                                Scrutiny scrutiny) {
  const auto folder = find_application(places, app);
  if (!folder) {
    say_error(console, folder.error().message);
    return exit_code::usage;
  }
  auto application = load_application(
      *folder, find_platform(places, *folder), scrutiny,
      std::make_shared<Catalogue>(plugin_folders(places, *folder)));
  if (!application.has_errors() && application.program)
    return application;
  print_lines(console.err, application.findings, places);
  say_error(console,
            app + " is not started: " + to_string(count(application.findings)));
  return exit_code::wrong;
}

} // namespace parlour::tools
