#include "script/source/findings.hpp"

#include <algorithm>
#include <cctype>
#include <tuple>
#include <utility>

#include "runtime/text/edit_distance.hpp"

namespace parlour::script {

namespace {

// The key for sorting. Files keep the order in which they were read.
auto order_of(const Finding& finding, const std::vector<std::string>& files) {
  const auto file = std::find(files.begin(), files.end(), finding.place.file);
  return std::tuple(file - files.begin(), finding.place.line,
                    finding.place.column, finding.severity,
                    std::string_view(finding.message));
}

char lower(char letter) {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
}

constexpr std::size_t longest = 64; // longer names are no misspellings

// Of the edit distance, in tenths: to insert, remove or replace a letter or to
// swap two neighbours costs 10; to change a letter's case costs 1.
struct LetterCosts {
  using Number = std::size_t;
  static constexpr Number swapped = 10;
  static Number change(char left, char right) {
    return left == right ? 0 : lower(left) == lower(right) ? 1 : 10;
  }
  static constexpr Number extra(char, char) {
    return 10;
  }
};

// The largest distance that counts as a misspelling: a third of the letters,
// but at least one letter. A name of one letter matches only in another case.
std::size_t tolerance(std::string_view name) {
  if (name.size() == 1)
    return 1;
  return std::max<std::size_t>(10, name.size() * 10 / 3);
}

// More findings help nobody, and each costs time.
constexpr std::size_t max_findings = 1000;

// Writes a correction as it must stand in the file. `delimiter` is the
// character before the value: the attribute's quote, or anything else for a
// text. If the correction contains that quote as its own string quotes, the
// other kind of quotes is used where this is possible without escapes.
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

// The format that editors and compilers use.
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

// When the limit is reached, one last finding says that there are more. Later
// errors only make sure that it counts as an error, because compiling fails by
// has_errors().
void Findings::add(Report report) {
  if (findings_.size() > max_findings) {
    if (report.severity == Severity::error)
      findings_.back().severity = Severity::error;
    return;
  }
  if (findings_.size() == max_findings)
    report = {report.severity, report.spot,
              "there is more; this is the last "
              "place that is told"};
  // The place as far as it is known without the file's text.
  const auto& spot = report.spot;
  Finding finding{report.severity, place(spot.start), std::move(report.message),
                  std::move(report.name)};
  const auto file = spot.start.file;
  finding.place.column += static_cast<std::uint32_t>(spot.skip);
  if (spot.start.line > 0 && file < texts_.size() &&
      !texts_[file].text().empty()) {
    // From the place in the value to bytes of the file, and from these back to
    // line and column: only this way entities, line ends and characters of
    // several bytes are counted right.
    const auto& source = texts_[file];
    const auto start = source.offset_of(spot.start);
    // The range in the file, and from it the exact place.
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

SourceLocation Findings::place(Position position) const {
  if (position.file >= files_.size())
    return {"", position.line, position.column};
  return {files_[position.file], position.line, position.column};
}

// Stable, so that findings about the same place keep the order of the passes.
void Findings::sort() {
  std::stable_sort(findings_.begin(), findings_.end(),
                   [this](const auto& a, const auto& b) {
                     return order_of(a, files_) < order_of(b, files_);
                   });
  // Neighbours that are equal in file, place, severity and message are the
  // same.
  auto last = std::unique(findings_.begin(), findings_.end(),
                          [this](const auto& a, const auto& b) {
                            return order_of(a, files_) == order_of(b, files_);
                          });
  findings_.erase(last, findings_.end());
}

std::string nearest(std::string_view name,
                    const std::vector<std::string>& candidates) {
  auto best = tolerance(name) + 1;
  std::string found;
  if (name.empty() || name.size() > longest)
    return found;
  for (const auto& candidate : candidates) {
    if (candidate.empty() || candidate.size() > longest)
      continue;
    const auto edits =
        edit_distance<longest, LetterCosts>(name, std::string_view(candidate));
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

// A name that is right already gets no hint.
std::string did_you_mean(std::string_view name,
                         const std::vector<std::string>& candidates) {
  auto near = nearest(name, candidates);
  return near.empty() || near == name ? "" : ", did you mean '" + near + "'?";
}

} // namespace parlour::script
