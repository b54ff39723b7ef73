// Application: one application compiled and looked through, everything that
// can be said without starting it. `check` prints the findings; all other
// commands refuse to go on where there are errors.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "script/compiler/compiler.hpp"
#include "script/program/program.hpp"
#include "script/source/findings.hpp"
#include "tools/parlour/application/column_reader.hpp"
#include "tools/parlour/application/composition.hpp"
#include "tools/parlour/console/places.hpp"

namespace parlour::tools {

struct Application {
  std::filesystem::path folder; // absolute
  std::filesystem::path platform;
  std::shared_ptr<const script::Program> program; // null where it has errors
  Composition composition;
  std::vector<script::Finding> findings; // all of them, sorted
  std::shared_ptr<Catalogue> plugins;    // never null

  bool has_errors() const;
};

// Whether what is right but probably not meant is looked for, too.
enum class Scrutiny { compile, lint };

// Compiles, checks plug-ins and options, loads the database's SQL in memory,
// reads the columns that grammars and slots name, builds the understanding.
// Creates nothing on the disk. `texts` stand for files, where it is not null.
Application load_application(
    const std::filesystem::path& folder, const std::filesystem::path& platform,
    Scrutiny scrutiny = Scrutiny::compile,
    std::shared_ptr<Catalogue> plugins = std::make_shared<Catalogue>(),
    const script::SourceTexts* texts = nullptr);

// What the compiler alone says of an application, and of one script file.
script::Compiled compile_folder(const std::filesystem::path& folder,
                                const std::filesystem::path& platform,
                                const script::SourceTexts* texts = nullptr);
script::Compiled load_file(const std::filesystem::path& file,
                           const Places& places,
                           const script::SourceTexts* texts = nullptr);

// Each Database component begins as a copy of its own, in memory where it is
// SQLite's, of what its schema and seed make (engine rule 7.5).
Composition in_memory(Composition composition);

} // namespace parlour::tools
