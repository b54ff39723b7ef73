// Catalogue: finds plug-ins by name, first in the program, then in plug-in
// folders. A plug-in that is a file is opened when it is first asked for.
#pragma once

#include <deque>
#include <filesystem>
#include <string>
#include <vector>

#include "adapters/plugins/plugin_folder.hpp"
#include "runtime/plugin/catalogue.hpp"

namespace parlour::tools {

// Where the program of MoonshineASR may be: in the source tree, or where it is
// installed; the best place first.
std::vector<std::filesystem::path> moonshine_programs();

// The plug-ins that are linked into this program. To add one, name its factory
// in catalogue.cpp.
const std::vector<PluginFactory>& built_in_plugins();
// One of them by its name; null if there is none.
const PluginFactory* find_plugin(std::string_view name);

class Catalogue : public PluginCatalogue {
  // Owned by an Application and shared with nodes. The lists of built-in
  // plug-ins and of folders do not change; folders lock their own state.
public:
  // `built_in` must outlive the catalogue. If two folders have a file of the
  // same name, the first folder wins.
  explicit Catalogue(
      const std::vector<std::filesystem::path>& folders = {},
      const std::vector<PluginFactory>& built_in = built_in_plugins());

  // The plug-in, or an error of kind Settings: there is none of that name (with
  // a suggestion), or its file cannot be loaded.
  Expected<PluginFactory> find(const std::string& name) override;
  // The descriptions of all plug-ins that can be loaded. Opens every file.
  std::vector<PluginDescription> all() override;

  // Whether there is such a plug-in, or a file of that name, loadable or not.
  bool has(const std::string& name) const;
  // The names of all plug-ins, loadable or not: those of the program in their
  // order, then files in alphabetical order.
  std::vector<std::string> names() const;
  // The file of a plug-in; empty if it is part of the program.
  std::filesystem::path file_of(const std::string& name) const;

private:
  // Null if the program has none of that name.
  const PluginFactory* built_in(const std::string& name) const;
  // The first folder that has a file of that name, or null.
  const adapters::PluginFolder* folder_of(const std::string& name) const;
  // The error for a name that is nowhere: a suggestion, or the folders
  // searched.
  Error nowhere(const std::string& name) const;

  const std::vector<PluginFactory>& built_in_;
  std::deque<adapters::PluginFolder> folders_;
};

} // namespace parlour::tools
