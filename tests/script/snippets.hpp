// Compiles small scripts and returns their findings.
#pragma once

#include <string>
#include <vector>

#include "script/compiler/compiler.hpp"
#include "script/xml/source_reader.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::test {

inline script::CompileOptions platform() {
  script::CompileOptions options;
  options.platform = source_path("config/platform");
  return options;
}

// The findings as lines, without the folder in front of file names.
inline std::vector<std::string> lines_of(const script::Findings& findings,
                                         const std::string& folder = "") {
  std::vector<std::string> lines;
  for (const auto& finding : findings.all()) {
    auto line = script::to_string(finding);
    for (auto at = line.find(folder + "/");
         !folder.empty() && at != std::string::npos;
         at = line.find(folder + "/"))
      line.erase(at, folder.size() + 1);
    lines.push_back(std::move(line));
  }
  return lines;
}

struct Outcome {
  std::shared_ptr<const script::Program> program;
  std::vector<std::string> lines;
};

// Compiles `text` as the only script of an application.
inline Outcome compile_text(const std::string& text) {
  TemporaryFolder folder;
  folder.write("settings.xml",
               "<settings><Scripts><Script>a.xml</Script></Scripts>"
               "</settings>");
  folder.write("a.xml", text);
  auto compiled = script::compile_application(folder.path(), platform());
  return {compiled.program,
          lines_of(compiled.findings, folder.path().string())};
}

// The same for the children of <dialogue>, which begin at line 1, column 11.
inline Outcome compile_declarations(const std::string& text) {
  return compile_text("<dialogue>" + text + "</dialogue>");
}

// The element tree of a well-formed text.
inline script::Element tree_of(const std::string& text) {
  script::Findings findings;
  auto root = script::read_source(text, findings.add_file("a.xml"), findings);
  return root ? std::move(*root) : script::Element{};
}

} // namespace parlour::test
