// ApplicationLoader: which files an application consists of, read and
// validated (language rules 1.6 and 1.8). A file included twice is read once;
// files that include each other are an error; no path leaves the application's
// folder.
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

// Texts that are read in the place of files, by the paths of these.
using SourceTexts = std::map<std::string, std::string>;

struct Document {
  Element root;
  bool platform = false; // one of the platform's libraries
};

class ApplicationLoader {
public:
  // `texts`, which may be null, must outlive it.
  ApplicationLoader(std::filesystem::path folder,
                    std::filesystem::path platform, Findings& findings,
                    const SourceTexts* texts = nullptr);

  // A script and what it includes, which comes before it; `position` is where
  // it was asked for.
  void load_script(const std::string& name, Position position);
  // "names" of <include href="parlour:names"/>.
  void load_library(const std::string& name, Position position);
  // A script that was read already, and what it includes.
  void add(const std::filesystem::path& path, Element root);

  // Registers, reads and validates one file; nothing where that failed.
  std::optional<Element> read(const std::filesystem::path& path,
                              const std::vector<std::string>& roots,
                              Position position);

  // A file inside of the application's folder, by its name relative to it; an
  // error's message is a whole sentence.
  Expected<std::filesystem::path> inside(const std::string& name) const;

  // Of what has been read; empty where there is none.
  std::string first_state() const;

  // In the order of inclusion; those that cannot be read are left out.
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
