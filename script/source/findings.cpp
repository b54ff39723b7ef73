#include "script/source/findings.hpp"

#include <algorithm>
#include <cctype>
#include <tuple>
#include <utility>

namespace parlour::script {

namespace {

// Files in the order in which they were read.
auto order_of(const Finding& finding, const std::vector<std::string>& files) {
  const auto file = std::find(files.begin(), files.end(), finding.place.file);
  return std::tuple(file - files.begin(), finding.place.line,
                    finding.place.column, finding.severity,
                    std::string_view(finding.message));
}

char lower(char letter) {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
}

// Edits (insert, remove, replace, swap neighbours) between two names, in
// tenths; another case of a letter costs little.
std::size_t distance(std::string_view a, std::string_view b) {
  const auto width = b.size() + 1;
  std::vector<std::size_t> table((a.size() + 1) * width);
  auto at = [&](std::size_t i, std::size_t j) -> std::size_t& {
    return table[i * width + j];
  };
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        at(i, j) = (i + j) * 10;
        continue;
      }
      const auto x = a[i - 1], y = b[j - 1];
      const std::size_t change = x == y ? 0 : lower(x) == lower(y) ? 1 : 10;
      at(i, j) = std::min(
          {at(i - 1, j) + 10, at(i, j - 1) + 10, at(i - 1, j - 1) + change});
      if (i > 1 && j > 1 && x == b[j - 2] && a[i - 2] == y)
        at(i, j) = std::min(at(i, j), at(i - 2, j - 2) + 10);
    }
  return table.back();
}

// A third of the letters may be wrong, one of a short name; of a name of one
// letter only its size.
std::size_t tolerance(std::string_view name) {
  if (name.size() == 1)
    return 1;
  return std::max<std::size_t>(10, name.size() * 10 / 3);
}

// More help nobody; and each costs time.
constexpr std::size_t most_findings = 1000;

// How a piece of a value is written in the file, where `delimiter` stands
// before the value. Strings in it get the other quotes where these end it and
// nothing in them is escaped.
std::string as_in_file(std::string text, char delimiter) {
  const char other = delimiter == '"' ? '\'' : '"';
  if ((delimiter == '"' || delimiter == '\'') &&
      text.find(other) == std::string::npos &&
      text.find('\\') == std::string::npos)
    std::replace(text.begin(), text.end(), delimiter, other);
  std::string written;
  for (const char letter : text)
    if (letter == '&')
      written += "&amp;";
    else if (letter == '<')
      written += "&lt;";
    else if (letter == delimiter && (letter == '"' || letter == '\''))
      written += letter == '"' ? "&quot;" : "&apos;";
    else
      written += letter;
  return written;
}

} // namespace

std::string to_string(const Finding& finding) {
  auto text = finding.place.file;
  if (finding.place.line > 0)
    text += ':' + std::to_string(finding.place.line) + ':' +
            std::to_string(finding.place.column);
  text += finding.severity == Severity::error ? ": error: " : ": warning: ";
  return text + finding.message;
}

std::uint16_t Findings::add_file(std::string name, std::string text) {
  files_.push_back(std::move(name));
  texts_.emplace_back(std::move(text));
  return static_cast<std::uint16_t>(files_.size() - 1);
}

void Findings::error(Position position, std::string message) {
  add({Severity::error, {position}, std::move(message)});
}

void Findings::warning(Position position, std::string message) {
  add({Severity::warning, {position}, std::move(message)});
}

void Findings::add(Report report) {
  if (findings_.size() > most_findings) {
    if (report.severity == Severity::error)
      findings_.back().severity = Severity::error;
    return;
  }
  if (findings_.size() == most_findings)
    report = {report.severity, report.spot,
              "there is more; this is the last "
              "place that is told"};
  const auto& spot = report.spot;
  Finding finding{report.severity, place(spot.start), std::move(report.message),
                  std::move(report.name)};
  const auto file = spot.start.file;
  finding.place.column += static_cast<std::uint32_t>(spot.skip);
  if (spot.start.line > 0 && file < texts_.size() &&
      !texts_[file].text().empty()) {
    const auto& source = texts_[file];
    const auto start = source.offset_of(spot.start);
    auto& [begin, end] = finding.range;
    begin = start;
    if (spot.skip > 0 || spot.collapsed)
      begin = source.inside(start, spot.skip, spot.collapsed);
    end = spot.length == 0 ? source.end_of(begin)
          : spot.raw
              ? begin + spot.length
              : source.inside(start, spot.skip + spot.length, spot.collapsed);
    const auto first = source.at(begin), last = source.at(end);
    finding.place = {files_[file], first.line, first.column};
    finding.end = {files_[file], last.line, last.column};
    if (report.replacement)
      finding.fix.push_back(
          {finding.range,
           spot.raw ? std::move(*report.replacement)
                    : as_in_file(*report.replacement,
                                 start > 0 ? source.text()[start - 1] : '\0')});
  }
  findings_.push_back(std::move(finding));
}

void Findings::add_edit(Edit edit) {
  findings_.back().fix.push_back(std::move(edit));
}

bool Findings::has_errors() const {
  return std::any_of(findings_.begin(), findings_.end(), [](const auto& one) {
    return one.severity == Severity::error;
  });
}

Place Findings::place(Position position) const {
  if (position.file >= files_.size())
    return {"", position.line, position.column};
  return {files_[position.file], position.line, position.column};
}

void Findings::sort() {
  std::stable_sort(findings_.begin(), findings_.end(),
                   [this](const auto& a, const auto& b) {
                     return order_of(a, files_) < order_of(b, files_);
                   });
  auto last = std::unique(findings_.begin(), findings_.end(),
                          [this](const auto& a, const auto& b) {
                            return order_of(a, files_) == order_of(b, files_);
                          });
  findings_.erase(last, findings_.end());
}

std::string nearest(std::string_view name,
                    const std::vector<std::string>& candidates) {
  constexpr std::size_t longest = 64; // names longer than that are no slips
  auto best = tolerance(name) + 1;
  std::string found;
  if (name.empty() || name.size() > longest)
    return found;
  for (const auto& candidate : candidates) {
    if (candidate.empty() || candidate.size() > longest)
      continue;
    const auto edits = distance(name, candidate);
    if (edits < best) {
      best = edits;
      found = candidate;
    }
  }
  return found;
}

std::string same_but_case(std::string_view name,
                          const std::vector<std::string>& candidates) {
  for (const auto& candidate : candidates)
    if (candidate != name &&
        std::equal(name.begin(), name.end(), candidate.begin(), candidate.end(),
                   [](char a, char b) { return lower(a) == lower(b); }))
      return candidate;
  return {};
}

std::string did_you_mean(std::string_view name,
                         const std::vector<std::string>& candidates) {
  auto near = nearest(name, candidates);
  return near.empty() || near == name ? "" : ", did you mean '" + near + "'?";
}

} // namespace parlour::script
