// Compiler: turns an application's folder, or a single file, into a Program. It
// reports all findings at once and returns no program if any of them is an
// error (language rule 1.3). The steps, each in a file of its own:
//
//   settings_reader         settings.xml as data
//   application_loader      files, validated trees
//   name_collector          everything with a name, before any code exists
//   declaration_compiler    topics, states, handlers … and their bodies (code/)
//   understanding_builder   what language understanding needs
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "script/compiler/application/application_loader.hpp"
#include "script/program/program.hpp"
#include "script/source/findings.hpp"

namespace parlour::script {

// How to compile. The pointers must stay valid during the call.
struct CompileOptions {
  std::filesystem::path platform; // the folder config/platform
  // Returns the value for ${NAME} in options of components; null: all are
  // empty.
  std::string (*environment)(const std::string& name) = nullptr;
  const SourceTexts* texts = nullptr; // unsaved texts of an editor
  // Of the platform, besides those that scripts include: "voice".
  std::vector<std::string> libraries = {};
  // Changes the settings once they are read; may be empty.
  std::function<void(Settings&)> adjust = nullptr;
};

// The result. Findings may include warnings even if there is a program.
struct Compiled {
  std::shared_ptr<const Program> program; // null if there are errors
  Findings findings;
  // The trees that were compiled, for lints and editors. They were repaired by
  // the validator if there are errors.
  std::vector<Document> documents{};
  std::optional<Element> settings{}; // of an application
};

// The settings file that applies: the application's own, or the platform's if
// the folder has scripts only.
std::filesystem::path settings_file(const std::filesystem::path& folder,
                                    const std::filesystem::path& platform);

// Compiles the application in a folder. Without settings.xml all scripts of the
// folder are compiled, and the first state begins (language rule 1.8).
Compiled compile_application(const std::filesystem::path& folder,
                             const CompileOptions& options);

// Compiles one script file for `exec` and `check`, with default settings.
Compiled compile_file(const std::filesystem::path& file,
                      const CompileOptions& options);

} // namespace parlour::script
