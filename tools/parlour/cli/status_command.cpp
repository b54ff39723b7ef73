#include <algorithm>
#include <ostream>

#include "tools/parlour/cli/commands.hpp"
#include "tools/parlour/console/exit_code.hpp"
#include "tools/parlour/status/runtime_folder.hpp"
#include "tools/parlour/status/status_client.hpp"

namespace parlour::tools {

namespace {

// By its name, or by its folder.
bool is_meant(const Places& places, const std::string& app,
              const StatusReport& report) {
  std::error_code code;
  return app.empty() || report.application == app ||
         std::filesystem::equivalent(places.working / app, report.folder, code);
}

// "; running: receptionist, butler".
std::string others(const std::vector<StatusReport>& reports) {
  std::string text;
  for (const auto& report : reports)
    text += (text.empty() ? "; running: " : ", ") + report.application;
  return text;
}

void print(const std::vector<StatusReport>& reports, bool json,
           std::ostream& out) {
  if (json)
    return print_json(out, reports);
  for (const auto& report : reports) {
    if (&report != &reports.front())
      out << '\n';
    print_table(out, report);
  }
}

} // namespace

int status_command(const Places& places, const StatusOptions& options,
                   const Console& console) {
  std::vector<StatusReport> all;
  int status = exit_code::success;
  for (auto& told : ask_status(runtime_folder(places))) {
    if (told) {
      all.push_back(std::move(*told));
      continue;
    }
    say_error(console, to_string(told.error()));
    status = exit_code::wrong;
  }
  std::vector<StatusReport> meant;
  std::ranges::copy_if(all, std::back_inserter(meant), [&](const auto& report) {
    return is_meant(places, options.app, report);
  });
  if (meant.empty()) {
    say_error(console,
              (options.app.empty() ? std::string("no application runs")
                                   : "'" + options.app + "' does not run") +
                  others(all) +
                  "; start one with parlour run APP (one with --clock "
                  "cannot be asked)");
    return exit_code::wrong;
  }
  print(meant, options.json, console.out);
  return status;
}

} // namespace parlour::tools
