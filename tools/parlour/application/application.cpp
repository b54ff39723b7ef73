#include "tools/parlour/application/application.hpp"

#include <algorithm>
#include <cstdlib>
#include <tuple>

#include "runtime/base/file_bytes.hpp"
#include "script/compiler/application_loader.hpp"
#include "script/compiler/settings_reader.hpp"
#include "script/lint/lint.hpp"
#include "tools/parlour/application/load_check.hpp"
#include "tools/parlour/application/resource_check.hpp"
#include "tools/parlour/application/sql_lint.hpp"

namespace parlour::tools {

namespace fs = std::filesystem;

namespace {

std::string environment_value(const std::string& name) {
  const auto* value = std::getenv(name.c_str());
  return value ? value : "";
}

script::CompileOptions compile_options(const fs::path& platform,
                                       const script::SourceTexts* texts) {
  return {platform, environment_value, texts};
}

// A plug-in that reads the platform's files is told where they are.
void tell_platform(Composition& composition, const fs::path& platform) {
  for (auto& component : composition.components)
    for (const auto& option : component.factory.description.options)
      if (option.name == "platform")
        component.options.emplace("platform", platform.string());
}

// The settings of an application whose scripts have errors: its components can
// be looked at all the same. What is wrong with the settings themselves the
// compiler has said.
Settings settings_alone(const fs::path& folder, const fs::path& platform,
                        const script::SourceTexts* texts) {
  script::Findings said;
  script::ApplicationLoader loader(folder, platform, said, texts);
  const auto settings =
      loader.read(script::settings_file(folder, platform), {"settings"}, {});
  const auto aliases = loader.read(platform / "aliases.xml", {"aliases"}, {});
  if (!settings)
    return {};
  return script::read_settings(
      *settings, aliases ? script::read_aliases(*aliases) : script::Aliases(),
      environment_value, said);
}

// Reads the settings once more: they are known to be readable, and who asks
// has a mistake to tell of.
std::optional<Place> place_of_option(const fs::path& folder,
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

script::Compiled no_application(const fs::path& folder) {
  script::Compiled compiled;
  const auto file = compiled.findings.add_file(folder.string());
  compiled.findings.error({file, {}},
                          "this folder is no application: there is neither "
                          "settings.xml nor a script (NAME.xml) in it");
  return compiled;
}

void sort(std::vector<script::Finding>& findings) {
  std::stable_sort(
      findings.begin(), findings.end(), [](const auto& a, const auto& b) {
        return std::tie(a.place.file, a.place.line, a.place.column) <
               std::tie(b.place.file, b.place.line, b.place.column);
      });
}

} // namespace

bool Application::has_errors() const {
  return std::any_of(findings.begin(), findings.end(), [](const auto& finding) {
    return finding.severity == script::Severity::error;
  });
}

Application load_application(const fs::path& folder, const fs::path& platform,
                             Scrutiny scrutiny,
                             std::shared_ptr<Catalogue> plugins,
                             const script::SourceTexts* texts) {
  Application application{folder, platform, nullptr, {}, {}, plugins};
  auto compiled = compile_folder(folder, platform, texts);
  application.program = compiled.program;
  application.composition = compose(
      application.program ? application.program->settings
                          : settings_alone(folder, platform, texts),
      *plugins, [&](const auto& component, const auto& option) {
        return place_of_option(folder, platform, texts, component, option);
      });
  tell_platform(application.composition, platform);
  if (scrutiny == Scrutiny::lint)
    lint(compiled, application);
  auto& findings = application.findings;
  findings = compiled.findings.all();
  const auto& chosen = application.composition.findings;
  findings.insert(findings.end(), chosen.begin(), chosen.end());
  const auto loads = check_loads(compiled, application.composition, *plugins);
  findings.insert(findings.end(), loads.begin(), loads.end());
  check_resources(application, columns_of_slots(compiled));
  sort(findings);
  if (application.has_errors())
    application.program = nullptr;
  return application;
}

script::Compiled compile_folder(const fs::path& folder,
                                const fs::path& platform,
                                const script::SourceTexts* texts) {
  if (!is_there(script::settings_file(folder, platform)))
    return no_application(folder);
  return script::compile_application(folder, compile_options(platform, texts));
}

script::Compiled load_file(const fs::path& file, const Places& places,
                           const script::SourceTexts* texts) {
  return script::compile_file(
      file, compile_options(find_platform(places, file.parent_path()), texts));
}

Composition in_memory(Composition composition) {
  for (auto& component : composition.components) {
    const auto& plugin = component.factory.description.name;
    if (plugin == "SQLiteDatabase")
      component.options.erase("file");
    else if (plugin == "MySQLDatabase")
      component.options["copy"] = "true";
  }
  return composition;
}

} // namespace parlour::tools
