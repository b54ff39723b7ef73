#include "script/source/excerpt.hpp"

#include <algorithm>

#include "runtime/base/text/utf8.hpp"

namespace parlour::script {

namespace {

constexpr std::size_t widest = 100;     // code points that are shown of a line
constexpr std::size_t longest = 10'000; // bytes; such a line is generated
constexpr std::size_t before_place = 60;
constexpr std::size_t narrowest_number = 5;

// Splits a line into its code points, each as its bytes.
std::vector<std::string> code_points(std::string_view line) {
  std::vector<std::string> points;
  for (const char byte : line)
    if (continues_code_point(byte) && !points.empty())
      points.back() += byte;
    else
      points.emplace_back(1, byte);
  return points;
}

// The line that contains the offset, without its end and a byte order mark.
std::string_view line_around(std::string_view text, std::size_t offset) {
  const auto begin = text.rfind('\n', offset == 0 ? 0 : offset - 1);
  const auto first =
      begin == std::string_view::npos || begin >= offset ? 0 : begin + 1;
  auto line = text.substr(first, text.find('\n', first) - first);
  while (line.ends_with('\r'))
    line.remove_suffix(1);
  return line.starts_with("\xef\xbb\xbf") ? line.substr(3) : line;
}

// The underlined part of the line, as code points [first, last).
struct Mark {
  std::size_t first = 0;
  std::size_t last = 0;
};

// The finding's own range if it has one, else the word or tag that begins
// there. A range that ends on a later line is underlined to the end of its
// first line.
Mark mark_of(const SourceText& source, const Finding& finding,
             std::size_t offset, std::size_t length) {
  const auto end = finding.range.end > finding.range.begin
                       ? source.at(finding.range.end)
                       : source.at(source.end_of(offset));
  const std::size_t first = finding.place.column - 1;
  const std::size_t last =
      end.line == finding.place.line ? end.column - 1 : length;
  return {first, std::max(last, first + 1)};
}

// The code points [first, last) as text.
std::string joined(const std::vector<std::string>& points, std::size_t first,
                   std::size_t last) {
  std::string text;
  for (auto i = first; i < std::min(last, points.size()); ++i)
    text += points[i];
  return text;
}

// Tabs are kept before the mark, so that it stands below the text however wide
// the terminal shows a tab.
std::string underline(const std::vector<std::string>& points, std::size_t first,
                      const Mark& mark, std::size_t last) {
  std::string text;
  for (auto i = first; i < mark.first; ++i)
    text += i < points.size() && points[i] == "\t" ? '\t' : ' ';
  return text +
         std::string(std::max(std::min(mark.last, last), mark.first + 1) -
                         mark.first,
                     '^');
}

} // namespace

// The place of a finding may come from another version of the file, so it is
// checked against the text before anything is shown.
std::string excerpt(const SourceText& source, const Finding& finding) {
  const auto& place = finding.place;
  if (place.line == 0 || place.column == 0 || source.text().empty())
    return {};
  const auto offset = source.offset_of({0, place.line, place.column});
  if (source.at(offset).line != place.line)
    return {};
  const auto line = line_around(source.text(), offset);
  if (line.size() > longest)
    return {};
  const auto points = code_points(line);
  const auto mark = mark_of(source, finding, offset, points.size());
  std::size_t first = 0;
  auto last = points.size();
  // Shows the part around the mark, with an ellipsis where it is cut.
  if (points.size() > widest) {
    first = mark.first > before_place ? mark.first - before_place : 0;
    last = std::min(first + widest, points.size());
  }
  const std::string before = first > 0 ? "…" : "";
  const std::string after = last < points.size() ? "…" : "";
  auto number = std::to_string(place.line);
  number.insert(0, narrowest_number - std::min(narrowest_number, number.size()),
                ' ');
  return number + " | " + before + joined(points, first, last) + after + '\n' +
         std::string(number.size(), ' ') + " | " + (first > 0 ? " " : "") +
         underline(points, first, mark, last) + '\n';
}

} // namespace parlour::script
