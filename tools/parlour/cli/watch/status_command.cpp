#include <algorithm>
#include <ostream>

#include "tools/parlour/cli/commands.hpp"
#include "tools/parlour/console/exit_code.hpp"
#include "tools/parlour/status/running_nodes.hpp"
#include "tools/parlour/status/runtime_folder.hpp"
#include "tools/parlour/status/status_client.hpp"

namespace parlour::tools {

namespace {

std::vector<std::string> names_of(const std::vector<StatusReport>& reports) {
  std::vector<std::string> names;
  for (const auto& report : reports)
    names.push_back(report.application);
  return names;
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
    return is_meant(places, options.app, report.application, report.folder);
  });
  if (meant.empty()) {
    say_error(console,
              (options.app.empty() ? std::string("no application runs")
                                   : "'" + options.app + "' does not run") +
                  also_running(names_of(all)) +
                  "; start one with parlour run APP (one with --clock "
                  "cannot be asked)");
    return exit_code::wrong;
  }
  print(meant, options.json, console.out);
  return status;
}

} // namespace parlour::tools
