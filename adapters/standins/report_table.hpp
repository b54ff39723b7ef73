// A table of answers that were written in advance: a file of tab-separated
// values. The first line names the columns: first the keys by which a row is
// found, then, anywhere, the column with the answer.
//
//  place      when   text                               temperature
//  Changi     *      Showers in the afternoon.          29
//  *          *      Partly cloudy over the island.     31
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "runtime/base/error.hpp"
#include "runtime/base/value.hpp"

namespace parlour::adapters {

struct Report {
  std::string text;
  // A map with every column of the row.
  Value data;
  // Its line in the file, from 1.
  std::uint32_t line = 0;
};

// In lower case (ASCII); keys are compared in this form.
std::string folded(std::string text);

// Immutable once read.
class ReportTable {
public:
  // Empty lines and lines that begin with '#' are ignored. `said` is the column
  // with the answer. The kind of an error is File if the file cannot be read,
  // and Settings, with its line, if a line is wrong.
  static Expected<ReportTable> read(const std::filesystem::path& file,
                                    const std::vector<std::string>& keys,
                                    const std::string& said = "text");

  // The first row whose keys match, without regard to capitals. The key `*`
  // matches everything, and an empty question matches every key.
  std::optional<Report> find(const std::vector<std::string>& asked) const;

  // All rows, in the file's order.
  std::vector<Report> reports() const;

  // The different first keys without `*`: what can be asked for.
  std::vector<std::string> subjects() const;

private:
  using Row = std::vector<std::string>;

  Report report(std::size_t row) const;

  std::size_t keys_ = 0;
  std::string said_;
  Row columns_;
  std::vector<Row> rows_;
  std::vector<std::uint32_t> lines_; // of the rows
};

} // namespace parlour::adapters
