#include <ostream>

#include "tools/parlour/application.hpp"
#include "tools/parlour/commands.hpp"
#include "tools/parlour/exit_code.hpp"
#include "tools/parlour/finding_text.hpp"

namespace parlour::tools {

namespace {

using Findings = std::vector<script::Finding>;

Expected<Findings> findings_of(const Places& places, const std::string& app) {
  std::error_code ignored;
  const auto path = places.working / app;
  if (std::filesystem::is_regular_file(path, ignored))
    return load_file(path, places).findings.all();
  return find_application(places, app).map([&](const auto& folder) {
    return load_application(folder, find_platform(places, folder)).findings;
  });
}

} // namespace

int check_command(const Places& places, const CheckOptions& options,
                  const Console& console) {
  const auto findings = findings_of(places, options.app);
  if (!findings) {
    say_error(console, findings.error().message);
    return exit_code::usage;
  }
  if (options.json)
    print_json(console.out, *findings);
  else
    print_lines(console.out, *findings, places);
  const auto counted = count(*findings);
  console.err << options.app << ": " << to_string(counted) << std::endl;
  return counted.errors > 0 ? exit_code::wrong : exit_code::well;
}

} // namespace parlour::tools
