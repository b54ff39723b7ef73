// Loads an application: calls the checks in their order and collects their
// findings.
#include "tools/parlour/application/application.hpp"

#include <algorithm>
#include <cstdlib>
#include <tuple>

#include "runtime/base/outside/file_bytes.hpp"
#include "script/compiler/application/application_loader.hpp"
#include "script/compiler/application/settings_reader.hpp"
#include "script/lint/lint.hpp"
#include "tools/parlour/application/agent_listener.hpp"
#include "tools/parlour/application/plugins/load_check.hpp"
#include "tools/parlour/application/plugins/seat_bindings.hpp"
#include "tools/parlour/application/plugins/shipped_plugin.hpp"
#include "tools/parlour/application/resource_check.hpp"
#include "tools/parlour/application/seat_events.hpp"
#include "tools/parlour/application/sql/sql_lint.hpp"

namespace parlour::tools {

namespace fs = std::filesystem;

namespace {

// The environment as settings may use it: an unset variable is empty.
std::string environment_value(const std::string& name) {
  const auto* value = std::getenv(name.c_str());
  return value ? value : "";
}

script::CompileOptions compile_options(const fs::path& platform,
                                       const Sources& sources) {
  return {platform, environment_value, sources.texts, sources.libraries,
          sources.adjust};
}

// Tells plug-ins that have an option "platform" where the platform's files are,
// unless the settings say it.
void tell_platform(Composition& composition, const fs::path& platform) {
  for (auto& component : composition.components)
    for (const auto& option : component.factory.description.options)
      if (option.name == "platform")
        component.options.emplace("platform", platform.string());
}

// Reads the settings again to find the place of one option (OptionPlaces).
std::optional<SourceLocation> place_of_option(const fs::path& folder,
                                              const fs::path& platform,
                                              const script::SourceTexts* texts,
                                              const std::string& component,
                                              const std::string& option) {
  script::Findings said;
  script::ApplicationLoader loader(folder, platform, said, texts);
  const auto settings =
      loader.read(script::settings_file(folder, platform), {"settings"}, {});
  if (!settings)
    return std::nullopt;
  for (const auto& element : settings->children)
    if (element.is("component") && element.value("name") == component)
      for (const auto& given : element.children)
        if (given.value("name") == option)
          return said.place(given.position);
  return std::nullopt;
}

// Lints need to know which roles and commands the components have.
void lint(script::Compiled& compiled, const Application& application) {
  script::lint::Options options;
  for (const auto& component : application.composition.components) {
    const auto& plugin = component.factory.description;
    options.component_roles[component.name] = plugin.roles;
    for (const auto& command : plugin.commands)
      options.component_commands[component.name].push_back(command.name);
  }
  lint_sql(compiled, application.composition, application.folder);
  script::lint::lint(compiled, options);
}

// The finding for a folder that holds no application at all.
script::Compiled no_application(const fs::path& folder) {
  script::Compiled compiled;
  const auto file = compiled.findings.add_file(folder.string());
  compiled.findings.error({file, {}},
                          "this folder is no application: there is neither "
                          "settings.xml nor a script (NAME.xml) in it");
  return compiled;
}

// Whether the addresses of <agents> can be read.
void check_agents(Application& application) {
  const auto& agents = application.program->settings.agents;
  if (agents.agents.empty())
    return;
  const auto options = server_options(agents, application.folder);
  if (!options)
    application.findings.push_back({script::Severity::error,
                                    options.error().place,
                                    "<agents>: " + options.error().message});
}

// By place; findings at the same place stay in the order of the checks.
void sort(std::vector<script::Finding>& findings) {
  std::stable_sort(
      findings.begin(), findings.end(), [](const auto& a, const auto& b) {
        return std::tie(a.place.file, a.place.line, a.place.column) <
               std::tie(b.place.file, b.place.line, b.place.column);
      });
}

} // namespace

std::string Application::name() const {
  const auto& given = program->settings.name;
  return given.empty() ? folder.filename().string() : given;
}

bool Application::has_errors() const {
  return std::any_of(findings.begin(), findings.end(), [](const auto& finding) {
    return finding.severity == script::Severity::error;
  });
}

// The compiler reports what is wrong with the settings, so these findings are
// dropped.
Settings settings_alone(const fs::path& folder, const fs::path& platform,
                        const Sources& sources) {
  script::Findings said;
  script::ApplicationLoader loader(folder, platform, said, sources.texts);
  const auto settings =
      loader.read(script::settings_file(folder, platform), {"settings"}, {});
  const auto aliases = loader.read(platform / "aliases.xml", {"aliases"}, {});
  if (!settings)
    return {};
  auto read = script::read_settings(
      *settings, aliases ? script::read_aliases(*aliases) : script::Aliases(),
      environment_value, said);
  read.folder = folder.string();
  if (sources.adjust)
    sources.adjust(read);
  return read;
}

Application load_application(const fs::path& folder, const fs::path& platform,
                             Scrutiny scrutiny,
                             std::shared_ptr<Catalogue> plugins,
                             const Sources& sources) {
  Application application{folder, platform, nullptr, {}, {}, plugins};
  // Compile. Without a program, the settings alone still say which components
  // there are.
  auto compiled = compile_folder(folder, platform, sources);
  application.program = compiled.program;
  const auto settings = application.program
                            ? application.program->settings
                            : settings_alone(folder, platform, sources);
  application.composition =
      // Only called during compose(), so references may be captured.
      compose(settings, *plugins,
              [&](const auto& component, const auto& option) {
                return place_of_option(folder, platform, sources.texts,
                                       component, option);
              });
  bind_to_seats(settings, application.composition);
  tell_platform(application.composition, platform);
  // The lints add to the compiler's findings, so they run before these are
  // copied. All later checks add to the application's findings.
  if (scrutiny == Scrutiny::lint)
    lint(compiled, application);
  auto& findings = application.findings;
  findings = compiled.findings.all();
  const auto& chosen = application.composition.findings;
  findings.insert(findings.end(), chosen.begin(), chosen.end());
  const auto loads = check_loads(compiled, application.composition, *plugins);
  findings.insert(findings.end(), loads.begin(), loads.end());
  check_resources(application, columns_of_slots(compiled));
  if (application.program) {
    check_agents(application);
    const auto openings =
        check_seat_events(*application.program, application.composition);
    findings.insert(findings.end(), openings.begin(), openings.end());
  }
  sort(findings);
  // A program may have compiled and a component may still be wrong: nobody
  // must run it then.
  if (application.has_errors())
    application.program = nullptr;
  return application;
}

script::Compiled compile_folder(const fs::path& folder,
                                const fs::path& platform,
                                const Sources& sources) {
  if (!is_there(script::settings_file(folder, platform)))
    return no_application(folder);
  return script::compile_application(folder,
                                     compile_options(platform, sources));
}

script::Compiled load_file(const fs::path& file, const Places& places,
                           const Sources& sources) {
  return script::compile_file(
      file,
      compile_options(find_platform(places, file.parent_path()), sources));
}

Composition rehearsed(Composition composition) {
  composition.is_rehearsed = true;
  for (auto& component : composition.components)
    rehearse(component.factory, component.options);
  return composition;
}

} // namespace parlour::tools
