// Finds the comments, works out which lines each one covers, and removes the
// warnings on these lines.

#include "script/xml/allowances.hpp"

#include <algorithm>
#include <cctype>
#include <map>

#include "script/xml/tag_scanner.hpp"

namespace parlour::script {

namespace {

constexpr auto npos = std::string_view::npos;
constexpr std::string_view opening = "<!--";
constexpr std::string_view closing = "-->";
constexpr std::string_view blanks = " \t\r\n";
constexpr std::string_view mark = "check: allow";
constexpr std::string_view everywhere = "in this file";

bool is_blank(std::string_view text) {
  return text.find_first_not_of(" \t\r") == npos;
}

// The names in a comment: runs of letters, digits and hyphens.
std::vector<std::string> names_in(std::string_view text) {
  std::vector<std::string> names(1);
  for (const char letter : text)
    if (std::isalnum(static_cast<unsigned char>(letter)) || letter == '-')
      names.back() += letter;
    else if (!names.back().empty())
      names.emplace_back();
  if (names.back().empty())
    names.pop_back();
  return names;
}

// Whether the allowance names the finding's lint and covers its line.
bool allows(const Allowance& allowance, const Finding& finding) {
  const auto& names = allowance.names;
  if (std::find(names.begin(), names.end(), finding.name) == names.end())
    return false;
  const auto line = finding.place.line;
  return allowance.whole_file ||
         (allowance.first <= line && line <= allowance.last);
}

// The offsets at which lines begin, for a text of any line length.
class Lines {
public:
  explicit Lines(std::string_view text) : text_(text) {
    for (auto at = text.find('\n'); at != npos; at = text.find('\n', at + 1))
      begins_.push_back(at + 1);
  }
  std::uint32_t number(std::size_t offset) const {
    return static_cast<std::uint32_t>(
        std::upper_bound(begins_.begin(), begins_.end(), offset) -
        begins_.begin());
  }
  // The part of the line that lies before the offset, and the part behind it.
  std::string_view before(std::size_t offset) const {
    const auto begin = begins_[number(offset) - 1];
    return text_.substr(begin, offset - begin);
  }
  std::string_view behind(std::size_t offset) const {
    return text_.substr(offset, text_.find('\n', offset) - offset);
  }

private:
  std::string_view text_;
  std::vector<std::size_t> begins_{0};
};

// The end of the last of the comments that stand on consecutive lines, starting
// from the comment that ends at `end`.
std::size_t end_of_comments(std::string_view text, std::size_t end) {
  for (;;) {
    const auto next = text.find_first_not_of(blanks, end);
    if (next == npos || !text.substr(next).starts_with(opening) ||
        std::count(text.begin() + static_cast<std::ptrdiff_t>(end),
                   text.begin() + static_cast<std::ptrdiff_t>(next), '\n') != 1)
      return end;
    const auto close = text.find(closing, next);
    if (close == npos)
      return end;
    end = close + closing.size();
  }
}

// Sets the lines of a comment: its own line, and if nothing else stands there,
// also the first line behind it that is not a comment.
void set_lines(Allowance& allowance, std::size_t begin, std::size_t end,
               std::string_view text, const Lines& lines) {
  allowance.first = allowance.last = lines.number(end);
  if (!allowance.whole_file && is_blank(lines.before(begin)) &&
      is_blank(lines.behind(end)))
    allowance.last = lines.number(end_of_comments(text, end)) + 1;
}

// Extends an allowance to all lines of each tag that it touches.
void add_lines_of_tags(std::vector<Allowance>& allowances,
                       std::string_view text, const Lines& lines) {
  std::vector<XmlMistake> ignored;
  const auto meant = allowances;
  for (auto at = text.find('<'); at != npos; at = text.find('<', at)) {
    const auto tag = scan_tag(text, at, ignored);
    const auto first = lines.number(at), last = lines.number(tag.end - 1);
    for (std::size_t i = 0; tag.kind != TagKind::other && i < meant.size(); ++i)
      if (meant[i].first <= last && first <= meant[i].last) {
        allowances[i].first = std::min(allowances[i].first, first);
        allowances[i].last = std::max(allowances[i].last, last);
      }
    at = std::max(tag.end, at + 1);
  }
}

} // namespace

// Searches for the mark rather than for comments, as most files have no
// allowance at all. The mark counts only at the beginning of a comment.
std::vector<Allowance> read_allowances(std::string_view text) {
  std::vector<Allowance> allowances;
  auto at = text.find(mark);
  if (at == npos)
    return allowances;
  const Lines lines(text);
  for (; at != npos; at = text.find(mark, at + 1)) {
    const auto begin = text.rfind(opening, at);
    const auto end = text.find(closing, at);
    if (begin == npos || end == npos ||
        !is_blank(
            text.substr(begin + opening.size(), at - begin - opening.size())))
      continue;
    // What follows the mark: names, and perhaps "in this file".
    const auto said = text.substr(at + mark.size(), end - at - mark.size());
    const auto whole = said.find(everywhere);
    auto& one = allowances.emplace_back();
    one.begin = at + mark.size();
    one.whole_file = whole != npos;
    one.names = names_in(said.substr(0, whole));
    set_lines(one, begin, end + closing.size(), text, lines);
  }
  add_lines_of_tags(allowances, text, lines);
  return allowances;
}

// The files are searched only if there is a warning.
void take_allowed(Findings& findings) {
  const auto& all = findings.all();
  if (std::none_of(all.begin(), all.end(), [](const Finding& finding) {
        return finding.severity == Severity::warning;
      }))
    return;
  std::map<std::string, std::vector<Allowance>> of_file;
  const auto& files = findings.files();
  for (std::size_t i = 0; i < files.size(); ++i)
    of_file.emplace(
        files[i],
        read_allowances(findings.text(static_cast<std::uint16_t>(i)).text()));
  findings.erase_if([&](const Finding& finding) {
    const auto found = of_file.find(finding.place.file);
    return finding.severity == Severity::warning && !finding.name.empty() &&
           found != of_file.end() &&
           std::any_of(
               found->second.begin(), found->second.end(),
               [&](const Allowance& one) { return allows(one, finding); });
  });
}

} // namespace parlour::script
