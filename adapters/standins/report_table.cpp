#include "adapters/standins/report_table.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>

#include "runtime/base/outside/file_bytes.hpp"

namespace parlour::adapters {

namespace {

// An empty line has one empty cell.
std::vector<std::string> cells_of(std::string line) {
  if (line.ends_with('\r'))
    line.pop_back();
  std::vector<std::string> cells;
  for (std::size_t start = 0; start <= line.size();) {
    const auto end = std::min(line.find('\t', start), line.size());
    cells.push_back(line.substr(start, end - start));
    start = end + 1;
  }
  return cells;
}

bool matches(const std::string& key, const std::string& asked) {
  return asked.empty() || key == "*" || folded(key) == folded(asked);
}

// The key columns come first, in order; the column of the answer is anywhere.
bool has_columns(const std::vector<std::string>& columns,
                 const std::vector<std::string>& keys,
                 const std::string& said) {
  return columns.size() > keys.size() &&
         std::equal(keys.begin(), keys.end(), columns.begin()) &&
         std::find(columns.begin(), columns.end(), said) != columns.end();
}

std::string header_of(const std::vector<std::string>& keys,
                      const std::string& said) {
  std::string header;
  for (const auto& key : keys)
    header += "'" + key + "', ";
  return header + '\'' + said + '\'';
}

} // namespace

std::string folded(std::string text) {
  for (auto& letter : text)
    letter =
        static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return text;
}

Expected<ReportTable> ReportTable::read(const std::filesystem::path& file,
                                        const std::vector<std::string>& keys,
                                        const std::string& said) {
  auto text = read_file(file);
  if (!text)
    return tl::make_unexpected(text.error());
  std::istringstream stream(std::move(*text));
  ReportTable table;
  table.keys_ = keys.size();
  table.said_ = said;
  // The line of the file, for errors.
  std::uint32_t number = 0;
  for (std::string line; std::getline(stream, line);) {
    const SourceLocation place{file.string(), ++number, 0};
    if (line.empty() || line == "\r" || line.starts_with('#'))
      continue;
    auto cells = cells_of(std::move(line));
    // A row with too few or too many cells is a mistake in the file.
    if (!table.columns_.empty() && cells.size() != table.columns_.size())
      return fail(ErrorKind::settings,
                  "A report has " + std::to_string(table.columns_.size()) +
                      " columns, this line " + std::to_string(cells.size()) +
                      ".",
                  place);
    if (!table.columns_.empty()) {
      table.rows_.push_back(std::move(cells));
      table.lines_.push_back(number);
    } else if (has_columns(cells, keys, said))
      table.columns_ = std::move(cells);
    else
      return fail(ErrorKind::settings,
                  "The first line names the columns, beginning with " +
                      header_of(keys, said) + ".",
                  place);
  }
  if (table.rows_.empty())
    return fail(ErrorKind::settings, "There is no report.",
                {file.string(), number, 0});
  return table;
}

std::optional<Report>
ReportTable::find(const std::vector<std::string>& asked) const {
  // Earlier rows win, so a general row (`*`) belongs at the end.
  const auto row =
      std::find_if(rows_.begin(), rows_.end(), [&](const Row& keys) {
        for (std::size_t i = 0; i < std::min(keys_, asked.size()); ++i)
          if (!matches(keys[i], asked[i]))
            return false;
        return true;
      });
  if (row == rows_.end())
    return {};
  return report(static_cast<std::size_t>(row - rows_.begin()));
}

Report ReportTable::report(std::size_t row) const {
  Map data;
  for (std::size_t i = 0; i < columns_.size(); ++i)
    data.set(columns_[i], rows_[row][i]);
  return {data.find(said_)->text(), data, lines_[row]};
}

std::vector<Report> ReportTable::reports() const {
  std::vector<Report> all;
  for (std::size_t row = 0; row < rows_.size(); ++row)
    all.push_back(report(row));
  return all;
}

std::vector<std::string> ReportTable::subjects() const {
  std::vector<std::string> names;
  for (const auto& row : rows_)
    if (row[0] != "*" &&
        std::find(names.begin(), names.end(), row[0]) == names.end())
      names.push_back(row[0]);
  return names;
}

} // namespace parlour::adapters
