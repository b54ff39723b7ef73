// ApplicationLoader: finds, reads and validates the files of an application
// (language rules 1.6 and 1.8). Each file is read once, however often it is
// included; files that include each other are an error; no path may leave the
// application's folder, also not by a link.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "runtime/base/error.hpp"
#include "script/source/findings.hpp"
#include "script/source/source.hpp"

namespace parlour::script {

// Unsaved texts of an editor, by path, which are read in the place of the
// files.
using SourceTexts = std::map<std::string, std::string>;

// One script as a validated tree.
struct Document {
  Element root;
  bool platform = false; // one of the platform's libraries
};

// Every problem becomes a finding; nothing throws. Used by one compilation.
class ApplicationLoader {
public:
  // `texts` may be null; otherwise it must outlive the loader.
  ApplicationLoader(std::filesystem::path folder,
                    std::filesystem::path platform, Findings& findings,
                    const SourceTexts* texts = nullptr);

  // Loads a script and everything that it includes, which comes before it in
  // the list of documents. `position` is where the script is named.
  void load_script(const std::string& name, Position position);
  // Loads the library "names" for <include href="parlour:names"/>.
  void load_library(const std::string& name, Position position);
  // Adds a script whose tree exists already, and loads what it includes.
  void add(const std::filesystem::path& path, Element root);

  // Registers, reads and validates one file; nothing if that failed.
  std::optional<Element> read(const std::filesystem::path& path,
                              const std::vector<std::string>& roots,
                              Position position);

  // The path of a file in the application's folder. The message of an error is
  // a complete sentence.
  Expected<std::filesystem::path> inside(const std::string& name) const;

  // The name of the first state in the scripts so far; empty if there is none.
  std::string first_state() const;

  // The documents in the order of inclusion, without those that cannot be read.
  std::vector<Document> take_documents() {
    return std::move(documents_);
  }

private:
  void load(const std::filesystem::path& path, bool platform,
            Position position);
  void add(const std::filesystem::path& real_path, Element root, bool platform);
  void include(const Element& element);
  std::vector<std::string> libraries() const;
  Expected<std::string> text_of(const std::filesystem::path& path) const;

  std::filesystem::path folder_;
  std::filesystem::path platform_;
  Findings& findings_;
  const SourceTexts* texts_;
  std::set<std::filesystem::path> read_;
  std::vector<std::filesystem::path> open_; // being read, outermost first
  std::vector<Document> documents_;
};

} // namespace parlour::script
