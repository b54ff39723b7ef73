// What the compiler and `check` have to say about an application: all of it,
// in the order of files and lines (language rule 1.3).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/error.hpp"
#include "script/source/source.hpp"
#include "script/source/source_text.hpp"

namespace parlour::script {

enum class Severity { error, warning };

// Replaces bytes of a file.
struct Edit {
  TextRange range;
  std::string text;

  bool operator==(const Edit&) const = default;
};

struct Finding {
  Severity severity = Severity::error;
  Place place;
  std::string message;
  std::string name{};      // what it is about: "xml", "expression", a lint …
  TextRange range{};       // what is underlined; empty: not known
  Place end{};             // behind it
  std::vector<Edit> fix{}; // safe to apply; empty: none
};

// Where inside of a value or text something stands.
struct Spot {
  Position start;         // of the value
  std::size_t skip = 0;   // bytes of the value before it
  std::size_t length = 0; // bytes; 0: what stands there (source_text.hpp)
  bool collapsed = false; // the value went through script::collapsed
  bool raw = false;       // `length` counts bytes of the file
};

// A finding as a pass of the compiler knows it.
struct Report {
  Severity severity = Severity::error;
  Spot spot{};
  std::string message{};
  std::string name{};
  // Safe to put in the place of what is underlined, as it shall stand in the
  // file; nothing where no correction is safe.
  std::optional<std::string> replacement{};
};

// "file:line:column: severity: message"
std::string to_string(const Finding& finding);

class Findings {
public:
  // Registers a file; its index is what Position::file holds. With its text,
  // places inside of values are exact.
  std::uint16_t add_file(std::string name, std::string text = {});

  void error(Position position, std::string message);
  void warning(Position position, std::string message);
  void add(Report report);
  // Another correction of the finding added last.
  void add_edit(Edit edit);

  bool has_errors() const;
  const std::vector<Finding>& all() const {
    return findings_;
  }
  const std::vector<std::string>& files() const {
    return files_;
  }
  Place place(Position position) const;
  // The text of a registered file; empty where it was not given.
  const SourceText& text(std::uint16_t file) const {
    return texts_.at(file);
  }
  // Sorts by file, line, column; drops repetitions.
  void sort();
  // Takes out the findings of which that is true.
  template <class Predicate>
  void erase_if(Predicate predicate) {
    std::erase_if(findings_, predicate);
  }

private:
  std::vector<std::string> files_;
  std::vector<SourceText> texts_;
  std::vector<Finding> findings_;
};

// The candidate nearest to a misspelt name, or empty where none is near.
std::string nearest(std::string_view name,
                    const std::vector<std::string>& candidates);

// The same where only small and capital letters differ; else empty.
std::string same_but_case(std::string_view name,
                          const std::vector<std::string>& candidates);

// The names of all, as candidates for what follows.
template <class All>
std::vector<std::string> names_in(const All& all) {
  std::vector<std::string> names;
  for (const auto& one : all)
    names.push_back(one.name);
  return names;
}

// ", did you mean 'x'?" or empty.
std::string did_you_mean(std::string_view name,
                         const std::vector<std::string>& candidates);

} // namespace parlour::script
