// `parlour check`. The findings come from application/application.hpp, the
// corrections from application/fix.hpp.
#include <algorithm>
#include <ostream>

#include "script/lint/lint.hpp"
#include "tools/parlour/application/application.hpp"
#include "tools/parlour/application/fix.hpp"
#include "tools/parlour/application/understanding.hpp"
#include "tools/parlour/cli/commands.hpp"
#include "tools/parlour/console/exit_code.hpp"
#include "tools/parlour/console/finding_text.hpp"
#include "tools/parlour/understand/example_report.hpp"

namespace parlour::tools {

namespace {

namespace fs = std::filesystem;
using Findings = std::vector<script::Finding>;

// What to check: an application's folder, or one script file.
struct Target {
  fs::path path;
  bool is_file = false;

  // The folder whose files --fix may change.
  fs::path folder() const {
    return is_file ? path.parent_path() : path;
  }
};

// A path to a file wins over an application of the same name.
Expected<Target> find_target(const Places& places, const std::string& app) {
  const auto path = places.working / app;
  if (is_file_like(path))
    return Target{path, true};
  return find_application(places, app).map([](const fs::path& folder) {
    return Target{folder, false};
  });
}

// Compiles and lints the target. `texts` replace the contents of files; --fix
// uses that to try corrections before it writes them.
Findings findings_of(const Places& places, const Target& target,
                     const script::SourceTexts& texts) {
  if (!target.is_file)
    return load_application(
               target.path, find_platform(places, target.path), Scrutiny::lint,
               std::make_shared<Catalogue>(plugin_folders(places, target.path)),
               {.texts = &texts})
        .findings;
  auto compiled = load_file(target.path, places, {.texts = &texts});
  script::lint::lint(compiled, {});
  return compiled.findings.all();
}

// What could be better about the examples of an application without errors.
void say_examples(const Places& places, const Target& target,
                  const Console& console) {
  const auto application = load_application(
      target.path, find_platform(places, target.path), Scrutiny::compile,
      std::make_shared<Catalogue>(plugin_folders(places, target.path)));
  const auto lines = example_report(try_examples(application));
  for (const auto& line : lines)
    console.out << line << '\n';
  if (lines.empty())
    console.out << "There are no examples that can be tried.\n";
}

// Prints each correction, and whether safe ones were left out because they
// would lead to more findings.
void say_fixed(const Places& places, const Corrected& corrected,
               const Console& console) {
  for (const auto& finding : corrected.made)
    console.err << shown_path(places, finding.place.file) << ':'
                << finding.place.line << ':' << finding.place.column
                << ": fixed: " << finding.message << '\n';
  if (std::any_of(corrected.findings.begin(), corrected.findings.end(),
                  [](const auto& finding) { return !finding.fix.empty(); }))
    console.err << "what can be corrected besides would leave more to do than "
                   "there is now; it is left to you\n";
}

// Corrects the files; `findings` is left with what remains to be said.
Expected<void> fix(const Places& places, const Target& target,
                   Findings& findings, const Console& console) {
  const auto check = [&](const script::SourceTexts& texts) {
    return findings_of(places, target, texts);
  };
  auto corrected = correct(std::move(findings), check, target.folder());
  findings = corrected.findings;
  if (auto written = write_texts(corrected.texts); !written)
    return written;
  say_fixed(places, corrected, console);
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
  if (options.examples && target->is_file) {
    say_error(console, "--examples reads those of an application, and '" +
                           options.app + "' is one file of it");
    return exit_code::usage;
  }
  // Print the findings that remain after --fix. Warnings do not change the exit
  // status.
  auto findings = findings_of(places, *target, {});
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
  if (options.examples && counted.errors == 0)
    say_examples(places, *target, console);
  console.err << options.app << ": " << to_string(counted) << std::endl;
  return counted.errors > 0 ? exit_code::wrong : exit_code::success;
}

} // namespace parlour::tools
