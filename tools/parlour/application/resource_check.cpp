#include "tools/parlour/application/resource_check.hpp"

#include <algorithm>
#include <functional>
#include <set>
#include <utility>

#include "tools/parlour/application/plugins/shipped_plugin.hpp"

namespace parlour::tools {

namespace {

using script::Severity;

// Adds an error. One without a place of its own is reported at the component.
void report(Application& application, const Error& error,
            const SourceLocation& otherwise, const std::string& component) {
  const auto has_place = !error.place.file.empty();
  auto place = has_place ? error.place : otherwise;
  // Editors expect columns to count from 1; 0 means unknown.
  place.column = std::max(place.column, 1u);
  application.findings.push_back(
      {Severity::error, std::move(place),
       has_place ? error.message : component + ": " + error.message});
}

// False if an option has the wrong type, which composition.cpp has reported
// already.
bool options_fit(const ChosenComponent& component) {
  const auto& all = component.factory.description.options;
  return std::ranges::all_of(all, [&](const OptionDescription& option) {
    const auto given = component.options.find(option.name);
    return given == component.options.end() ||
           check_option(option, given->second);
  });
}

void warn(Application& application, SourceLocation place, std::string text,
          std::string rule) {
  place.column = std::max(place.column, 1u);
  application.findings.push_back(
      {Severity::warning, std::move(place), std::move(text), std::move(rule)});
}

// Warns of files that an option names and that do not exist.
void check_presence(Application& application, const ChosenComponent& component,
                    const ShippedPlugin& plugin) {
  for (const auto option : plugin.file_options) {
    const auto given = component.options.find(std::string(option));
    std::error_code ignored;
    if (given == component.options.end() || given->second.empty() ||
        std::filesystem::is_regular_file(application.folder / given->second,
                                         ignored))
      continue;
    warn(application, component.place,
         component.name + ": there is no file '" + given->second +
             "', which the option '" + std::string(option) +
             "' names, in the application's folder",
         "missing-file");
  }
}

void check_contents(Application& application, const ChosenComponent& component,
                    const ShippedPlugin& plugin) {
  const auto mistakes =
      plugin.check_files(component.options, application.folder);
  for (const auto& error : mistakes.errors)
    report(application, error, component.place, component.name);
  for (const auto& missing : mistakes.missing_secrets)
    warn(application, missing.place, missing.message, "missing-secret");
}

// False if a database cannot be made: reading its columns would report the same
// again.
bool check_files(Application& application) {
  bool databases_fit = true;
  for (const auto& component : application.composition.components) {
    const auto& plugin = shipped_plugin(component.factory.description.name);
    check_presence(application, component, plugin);
    const auto before = application.findings.size();
    const bool fit = options_fit(component);
    if (plugin.check_files && fit)
      check_contents(application, component, plugin);
    if (plugin.columns && (!fit || application.findings.size() > before))
      databases_fit = false;
  }
  return databases_fit;
}

// Reports columns that cannot be read where they are named. The returned reader
// treats them as empty, so that the understanding does not report them again.
ColumnReader check_columns(Application& application,
                           const std::vector<NamedColumn>& columns) {
  const auto reader =
      column_reader(rehearsed(application.composition), application.folder, "");
  std::set<std::string> unreadable;
  for (const auto& [name, place] : columns)
    if (const auto values = reader(name); !values) {
      application.findings.push_back(
          {Severity::error, place, values.error().message});
      unreadable.insert(name);
    }
  return [reader, unreadable](
             const std::string& name) -> Expected<std::vector<std::string>> {
    if (unreadable.count(name) > 0)
      return std::vector<std::string>();
    return reader(name);
  };
}

} // namespace

// Collects the attribute `source` of every <cardinality>, recursively.
std::vector<NamedColumn> columns_of_slots(const script::Compiled& compiled) {
  std::vector<NamedColumn> columns;
  const std::function<void(const script::Element&)> look =
      [&](const script::Element& element) {
        const auto* source = element.attribute("source");
        if (element.is("cardinality") && source)
          columns.push_back(
              {source->value, compiled.findings.place(source->value_position)});
        for (const auto& child : element.children)
          look(child);
      };
  for (const auto& document : compiled.documents)
    look(document.root);
  return columns;
}

void check_resources(Application& application,
                     const std::vector<NamedColumn>& columns) {
  if (!check_files(application) || !application.program)
    return;
  const auto reader = check_columns(application, columns);
  const auto& model = application.program->understanding;
  for (const auto& component : application.composition.components)
    if (const auto check = shipped_plugin(component.factory.description.name)
                               .check_understanding)
      for (const auto& error :
           check(component.options, application.folder,
                 model ? *model : UnderstandingModel{}, reader))
        report(application, error, component.place, component.name);
}

} // namespace parlour::tools
