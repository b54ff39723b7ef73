// What the program knows of the plug-ins that it ships beyond what they say of
// themselves: how to read today what they will read when they start, and how
// they run where nothing outside may be reached. All of it is one table
// (shipped_plugin.cpp); nothing else tells plug-ins by their names.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

#include "adapters/nlu/understand/left_out.hpp"
#include "runtime/message/understanding.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::tools {

// What is wrong with the files that a component reads. An error without a place
// of its own belongs to the component's.
struct Mistakes {
  std::vector<Error> errors;
  std::vector<Error> missing_secrets; // warnings
};

struct ShippedPlugin {
  std::string_view name;

  // Options that name files of the application which are read at the start. A
  // missing one is a warning.
  std::vector<std::string_view> file_options = {};

  // Completes a description that is data: roles, commands and events of an
  // HTTPService are in its file of rules. Does nothing if the file cannot be
  // read, which check_files tells.
  void (*describe)(PluginDescription& plugin, const Options& options,
                   const std::filesystem::path& application) = nullptr;

  // Makes of it what starts afresh, keeps nothing and reaches nobody (engine
  // rule 7.5).
  void (*rehearse)(PluginFactory& factory, Options& options) = nullptr;

  // Reads its files. Writes nothing and asks no server.
  Mistakes (*check_files)(const Options& options,
                          const std::filesystem::path& application) = nullptr;

  // Builds the understanding of an application that has compiled.
  std::vector<Error> (*check_understanding)(
      const Options& options, const std::filesystem::path& application,
      const UnderstandingModel& model, const ColumnReader& columns) = nullptr;

  // Reads the application's examples as if each were not there.
  std::vector<adapters::nlu::LeftOutExample> (*try_examples)(
      const Options& options, UnderstandingModel model,
      const ColumnReader& columns, const std::string& application) = nullptr;

  // Of a database: reads its columns, without the component.
  ColumnReader (*columns)(const Options& options,
                          const std::filesystem::path& application,
                          const std::string& data_folder) = nullptr;
  // The file that keeps its data; empty: none, or the options are wrong.
  std::filesystem::path (*kept_file)(const Options& options,
                                     const std::filesystem::path& application,
                                     const std::string& data_folder) = nullptr;
  // It needs a library that not every build has; without it an application
  // still runs, and this is what happens instead. Empty: an application that
  // names it needs it.
  std::string_view without = {};
  // Whether what it needs besides this program is there; null: it needs
  // nothing.
  bool (*is_installed)() = nullptr;
  // Hears or writes this file, wherever it is.
  PluginFactory (*for_file)(const std::filesystem::path& file) = nullptr;
  // It reads the terminal, so that nothing can be typed there.
  bool (*takes_terminal)(const Options& options) = nullptr;
  // It speaks SQLite's dialect, so that every mistake in its SQL can be told.
  bool speaks_sqlite = false;
};

// That of a plug-in that is not shipped, or of which nothing is known, is
// empty.
const ShippedPlugin& shipped_plugin(std::string_view name);

// Calls its `is_installed`, `describe` and `rehearse`, where it has them.
bool is_installed(std::string_view name);
void complete_description(PluginDescription& plugin, const Options& options,
                          const std::filesystem::path& application);
void rehearse(PluginFactory& factory, Options& options);

} // namespace parlour::tools
