// Findings: everything that the compiler and `parlour check` report about an
// application, collected and then sorted by file, line and column (language
// rule 1.3).
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

// A replacement of bytes of one file, for `parlour check --fix` and editors.
struct Edit {
  TextRange range;
  std::string text;

  bool operator==(const Edit&) const = default;
};

// One finding as people and editors get it.
struct Finding {
  Severity severity = Severity::error;
  SourceLocation place;
  std::string message;
  std::string name{};      // what it is about: "xml", "expression", a lint …
  TextRange range{};       // what is underlined; empty if not known
  SourceLocation end{};    // where the range ends
  std::vector<Edit> fix{}; // safe to apply; empty if there is none
};

// A place inside of an attribute's value or of a text, in terms of the value as
// the parser delivers it (entities replaced). Findings translates it to bytes
// of the file.
struct Spot {
  Position start;         // where the value begins
  std::size_t skip = 0;   // bytes of the value before the place
  std::size_t length = 0; // bytes; 0: the word or tag that begins there
  bool collapsed = false; // the value was passed through script::collapsed
  bool raw = false;       // `length` counts bytes of the file
};

// A finding as a pass of the compiler reports it.
struct Report {
  Severity severity = Severity::error;
  Spot spot{};
  std::string message{};
  std::string name{};
  // A correction that can replace what is underlined, as plain text: characters
  // that XML reserves are escaped when it is applied. Nothing if no correction
  // is certainly right.
  std::optional<std::string> replacement{};
};

// "file:line:column: severity: message".
std::string to_string(const Finding& finding);

// Collects the findings of all passes. Owns the texts of the files that they
// refer to. Keeps at most about a thousand findings. Not thread-safe.
//
// An example:
//
//   Findings findings;
//   const auto file = findings.add_file("main.xml", text);
//   findings.error({file, 3, 5}, "there is no state 'Bye'");
//   findings.sort();
//   for (const auto& finding : findings.all())
//     std::cout << to_string(finding) << '\n' << excerpt(…);
class Findings {
public:
  // Registers a file and returns its index, which is what Position::file holds.
  // If the text is given, places inside of values become exact.
  std::uint16_t add_file(std::string name, std::string text = {});

  void error(Position position, std::string message);
  void warning(Position position, std::string message);
  void add(Report report);
  // Adds a further edit to the correction of the finding that was added last.
  void add_edit(Edit edit);

  bool has_errors() const;
  const std::vector<Finding>& all() const {
    return findings_;
  }
  const std::vector<std::string>& files() const {
    return files_;
  }
  SourceLocation place(Position position) const;
  // The text of a registered file; empty if it was registered without.
  const SourceText& text(std::uint16_t file) const {
    return texts_.at(file);
  }
  // Sorts by file, line and column and removes duplicates.
  void sort();
  // Removes the findings for which the predicate is true.
  template <class Predicate>
  void erase_if(Predicate predicate) {
    std::erase_if(findings_, predicate);
  }

private:
  std::vector<std::string> files_;
  std::vector<SourceText> texts_;
  std::vector<Finding> findings_;
};

// The candidate that is most similar to a misspelt name; empty if none is
// similar enough. Takes time in proportion to all letters of the candidates.
std::string nearest(std::string_view name,
                    const std::vector<std::string>& candidates);

// The candidate that differs from the name in the case of letters only; empty
// if there is none.
std::string same_but_case(std::string_view name,
                          const std::vector<std::string>& candidates);

// The names of all elements of a list, as candidates for the functions here.
template <class All>
std::vector<std::string> names_in(const All& all) {
  std::vector<std::string> names;
  for (const auto& one : all)
    names.push_back(one.name);
  return names;
}

// ", did you mean 'x'?", or empty if no candidate is similar.
std::string did_you_mean(std::string_view name,
                         const std::vector<std::string>& candidates);

} // namespace parlour::script
