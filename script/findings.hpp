// What the compiler and `check` have to say about an application: all of it,
// in the order of files and lines (language rule 1).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/error.hpp"
#include "script/source.hpp"

namespace parlour::script {

enum class Severity { error, warning };

struct Finding {
  Severity severity = Severity::error;
  Place place;
  std::string message;
};

// "file:line:column: severity: message"
std::string to_string(const Finding& finding);

class Findings {
public:
  // Registers a file; its index is what Position::file holds.
  std::uint16_t add_file(std::string name);

  void error(Position position, std::string message);
  void warning(Position position, std::string message);

  bool has_errors() const;
  const std::vector<Finding>& all() const {
    return findings_;
  }
  const std::vector<std::string>& files() const {
    return files_;
  }
  Place place(Position position) const;
  // Sorts by file, line, column; drops repetitions.
  void sort();

private:
  std::vector<std::string> files_;
  std::vector<Finding> findings_;
};

// The candidate nearest to a misspelt name, or empty where none is near.
std::string nearest(std::string_view name,
                    const std::vector<std::string>& candidates);

// ", did you mean 'x'?" or empty.
std::string did_you_mean(std::string_view name,
                         const std::vector<std::string>& candidates);

} // namespace parlour::script
