#include "script/source/excerpt.hpp"

#include <algorithm>

#include "runtime/base/utf8.hpp"

namespace parlour::script {

namespace {

constexpr std::size_t widest = 100;     // code points of a line that are shown
constexpr std::size_t longest = 10'000; // bytes; nobody wrote such a line
constexpr std::size_t before_place = 60;
constexpr std::size_t narrowest_number = 5;

// The line's code points, each as its bytes.
std::vector<std::string> code_points(std::string_view line) {
  std::vector<std::string> points;
  for (const char byte : line)
    if (continues_code_point(byte) && !points.empty())
      points.back() += byte;
    else
      points.emplace_back(1, byte);
  return points;
}

std::string_view line_around(std::string_view text, std::size_t offset) {
  const auto begin = text.rfind('\n', offset == 0 ? 0 : offset - 1);
  const auto first =
      begin == std::string_view::npos || begin >= offset ? 0 : begin + 1;
  auto line = text.substr(first, text.find('\n', first) - first);
  while (line.ends_with('\r'))
    line.remove_suffix(1);
  return line.starts_with("\xef\xbb\xbf") ? line.substr(3) : line;
}

// The underlined code points: [first, last) of the line.
struct Mark {
  std::size_t first = 0;
  std::size_t last = 0;
};

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

std::string joined(const std::vector<std::string>& points, std::size_t first,
                   std::size_t last) {
  std::string text;
  for (auto i = first; i < std::min(last, points.size()); ++i)
    text += points[i];
  return text;
}

// Tabs stay tabs, so that the mark stands where the text does.
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
