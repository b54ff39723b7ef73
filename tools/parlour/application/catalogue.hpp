// Catalogue: the plug-ins of this program, then those of plug-in folders.
#pragma once

#include <deque>
#include <filesystem>
#include <string>
#include <vector>

#include "adapters/plugins/plugin_folder.hpp"
#include "runtime/plugin/catalogue.hpp"

namespace parlour::tools {

// Every plug-in that is part of this program.
const std::vector<PluginFactory>& built_in_plugins();
const PluginFactory* find_plugin(std::string_view name);

class Catalogue : public PluginCatalogue {
public:
  // `built_in` outlives the catalogue. Of two files of one name that of the
  // first folder counts.
  explicit Catalogue(
      const std::vector<std::filesystem::path>& folders = {},
      const std::vector<PluginFactory>& built_in = built_in_plugins());

  Expected<PluginFactory> find(const std::string& name) override;
  std::vector<PluginDescription> all() override;

  // Whether it is part of the program, or there is a file, good or bad.
  bool has(const std::string& name) const;
  // Of all plug-ins, whether their files can be used or not.
  std::vector<std::string> names() const;
  // Where the plug-in comes from; empty for one that is part of the program.
  std::filesystem::path file_of(const std::string& name) const;

private:
  const PluginFactory* built_in(const std::string& name) const;
  const adapters::PluginFolder* folder_of(const std::string& name) const;
  Error nowhere(const std::string& name) const;

  const std::vector<PluginFactory>& built_in_;
  std::deque<adapters::PluginFolder> folders_;
};

} // namespace parlour::tools
