#include <ostream>

#include "script/lint/lint.hpp"
#include "tools/parlour/application.hpp"
#include "tools/parlour/commands.hpp"
#include "tools/parlour/exit_code.hpp"
#include "tools/parlour/finding_text.hpp"
#include "tools/parlour/fix.hpp"

namespace parlour::tools {

namespace {

namespace fs = std::filesystem;
using Findings = std::vector<script::Finding>;

// A correction may show what stood behind the mistake; never without end.
constexpr int most_rounds = 10;

// What is checked: one file, or an application's folder.
struct Target {
  fs::path path;
  bool is_file = false;

  fs::path folder() const {
    return is_file ? path.parent_path() : path;
  }
};

Expected<Target> find_target(const Places& places, const std::string& app) {
  const auto path = places.working / app;
  if (is_file_like(path))
    return Target{path, true};
  return find_application(places, app).map([](const fs::path& folder) {
    return Target{folder, false};
  });
}

Findings findings_of(const Places& places, const Target& target) {
  if (!target.is_file)
    return load_application(
               target.path, find_platform(places, target.path), Scrutiny::lint,
               std::make_shared<Catalogue>(plugin_folders(places, target.path)))
        .findings;
  auto compiled = load_file(target.path, places);
  script::lint::lint(compiled, {});
  return compiled.findings.all();
}

void say_fixed(const Places& places, const std::vector<FixedFile>& files,
               const Console& console) {
  for (const auto& file : files)
    for (const auto& finding : file.fixed)
      console.err << shown_path(places, file.file) << ':' << finding.place.line
                  << ':' << finding.place.column
                  << ": fixed: " << finding.message << '\n';
}

// Corrects until nothing more can be; leaves the findings that remain.
Expected<void> fix(const Places& places, const Target& target,
                   Findings& findings, const Console& console) {
  for (int round = 0; round < most_rounds; ++round) {
    const auto files = fix_files(findings, target.folder());
    if (!files)
      return tl::make_unexpected(files.error());
    if (files->empty())
      break;
    say_fixed(places, *files, console);
    findings = findings_of(places, target);
  }
  return {};
}

} // namespace

int check_command(const Places& places, const CheckOptions& options,
                  const Console& console) {
  const auto target = find_target(places, options.app);
  if (!target) {
    say_error(console, target.error().message);
    return exit_code::usage;
  }
  auto findings = findings_of(places, *target);
  if (options.fix)
    if (const auto fixed = fix(places, *target, findings, console); !fixed) {
      say_error(console, to_string(fixed.error()));
      return exit_code::wrong;
    }
  if (options.json)
    print_json(console.out, findings);
  else
    print_lines(console.out, findings, places);
  const auto counted = count(findings);
  console.err << options.app << ": " << to_string(counted) << std::endl;
  return counted.errors > 0 ? exit_code::wrong : exit_code::well;
}

} // namespace parlour::tools
