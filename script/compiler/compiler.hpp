// Compiler: from an application's folder (or one file) to a Program. Reports
// every finding in one go; gives no program when there are errors (language
// rule 1.3).
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "script/compiler/application_loader.hpp"
#include "script/program/program.hpp"
#include "script/source/findings.hpp"

namespace parlour::script {

struct CompileOptions {
  std::filesystem::path platform; // the folder of config/platform
  // Replaced in ${NAME} of options; null: none is set.
  std::string (*environment)(const std::string& name) = nullptr;
  const SourceTexts* texts = nullptr; // read in the place of files
};

struct Compiled {
  std::shared_ptr<const Program> program; // null where there are errors
  Findings findings;
  // What it was made of, for those that look further; mended by the validator
  // where there are errors.
  std::vector<Document> documents{};
  std::optional<Element> settings{}; // of an application
};

// The settings that an application has: its own, or those of the platform where
// it is a folder of scripts only.
std::filesystem::path settings_file(const std::filesystem::path& folder,
                                    const std::filesystem::path& platform);

// An application's folder with its settings.xml; without one, all scripts of
// the folder, beginning in their first state.
Compiled compile_application(const std::filesystem::path& folder,
                             const CompileOptions& options);

// One script file, for `exec` and `check`: default settings, the platform's
// libraries by <include href="parlour:…"/>.
Compiled compile_file(const std::filesystem::path& file,
                      const CompileOptions& options);

} // namespace parlour::script
