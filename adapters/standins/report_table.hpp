// Reports written beforehand: a file of tab-separated values whose first line
// names the columns. Key columns come first; `text` is what is said.
//
//   place      when   text                               temperature
//   Changi     *      Showers in the afternoon.          29
//   *          *      Partly cloudy over the island.     31
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "runtime/base/error.hpp"
#include "runtime/base/value.hpp"

namespace parlour::adapters {

struct Report {
  std::string text;
  Value data; // a map: every column of the row
};

// Small and capital letters are the same where reports are looked for.
std::string folded(std::string text);

class ReportTable {
public:
  // Empty lines and those that begin with '#' do not count. Errors: File for
  // one that cannot be read, Settings with the line that is wrong. `said` is
  // the column that reports take their text from.
  static Expected<ReportTable> read(const std::filesystem::path& file,
                                    const std::vector<std::string>& keys,
                                    const std::string& said = "text");

  // The first row whose keys match what is asked, spelling case aside; `*`
  // matches everything, and so does an empty question.
  std::optional<Report> find(const std::vector<std::string>& asked) const;

  // The distinct first keys, without `*`: what can be asked for.
  std::vector<std::string> subjects() const;

private:
  using Row = std::vector<std::string>;

  std::size_t keys_ = 0;
  std::string said_;
  Row columns_;
  std::vector<Row> rows_;
};

} // namespace parlour::adapters
