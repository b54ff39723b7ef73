// Application: an application that has been compiled and checked, but not
// started. load_application() collects every mistake that can be found without
// starting it. `parlour check` prints them; the other commands go on only if
// there are no errors (opening.hpp).
//
// The order of the checks: compile the scripts (script/compiler), choose
// plug-ins and check their options (composition.hpp), lint (script/lint,
// sql_lint.hpp), check <load> statements (load_check.hpp), read what components
// will read (resource_check.hpp).
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "script/compiler/compiler.hpp"
#include "script/program/program.hpp"
#include "script/source/findings.hpp"
#include "tools/parlour/application/plugins/composition.hpp"
#include "tools/parlour/application/sql/column_reader.hpp"
#include "tools/parlour/console/places.hpp"

namespace parlour::tools {

// Immutable once it is loaded; safe to share between threads, apart from
// `plugins`, whose files are opened when they are asked for.
struct Application {
  std::filesystem::path folder; // absolute
  // The folder of the platform's own files (find_platform).
  std::filesystem::path platform;
  std::shared_ptr<const script::Program> program; // null if there are errors
  Composition composition;
  std::vector<script::Finding> findings; // sorted by file and line
  std::shared_ptr<Catalogue> plugins;    // never null; shared with nodes

  bool has_errors() const;
  // As the settings call it, else that of its folder.
  std::string name() const;
};

// Whether lints run, too: warnings about code that is correct but probably not
// meant.
enum class Scrutiny { compile, lint };

// What is compiled, apart from the files of the application's folder.
struct Sources {
  // Replace the contents of files by name; may be null. Need to live only
  // during the call.
  const script::SourceTexts* texts = nullptr;
  // Of the platform, besides those that scripts include.
  std::vector<std::string> libraries = {};
  // What a run changes in the settings; may be empty.
  std::function<void(Settings&)> adjust = nullptr;
};

// Loads the application in `folder`, which must be absolute. Never fails: what
// is wrong is in `findings`.
//
// Runs the databases' schema and seed in memory, reads the columns that slots
// and grammars name, and builds the understanding. Writes nothing to the disk
// and asks no database server.
Application load_application(
    const std::filesystem::path& folder, const std::filesystem::path& platform,
    Scrutiny scrutiny = Scrutiny::compile,
    std::shared_ptr<Catalogue> plugins = std::make_shared<Catalogue>(),
    const Sources& sources = {});

// Only the compiler's part: an application's scripts, or one script file with
// the platform's libraries.
script::Compiled compile_folder(const std::filesystem::path& folder,
                                const std::filesystem::path& platform,
                                const Sources& sources = {});
script::Compiled load_file(const std::filesystem::path& file,
                           const Places& places, const Sources& sources = {});

// The settings alone, for an application whose scripts do not compile, or whose
// components are needed first. What is wrong with them is not told.
Settings settings_alone(const std::filesystem::path& folder,
                        const std::filesystem::path& platform,
                        const Sources& sources = {});

// A copy of the composition in which each database component starts from its
// schema and seed and keeps nothing (engine rule 7.5): SQLite's in memory, a
// server's as a copy of its own. An HTTPService asks nobody: the samples of its
// rules answer. MQTTDevices switches nothing: LogDevices stands in. The same
// goes for what scripts <load>.
Composition rehearsed(Composition composition);

} // namespace parlour::tools
