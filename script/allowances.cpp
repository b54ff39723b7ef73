#include "script/allowances.hpp"

#include <algorithm>
#include <cctype>
#include <map>

namespace parlour::script {

namespace {

constexpr auto npos = std::string_view::npos;
constexpr std::string_view opening = "<!--";
constexpr std::string_view mark = "check: allow";
constexpr std::string_view everywhere = "in this file";

bool is_blank(std::string_view text) {
  return text.find_first_not_of(" \t\r") == npos;
}

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

bool allows(const Allowance& allowance, const Finding& finding) {
  const auto& names = allowance.names;
  if (std::find(names.begin(), names.end(), finding.name) == names.end())
    return false;
  const auto line = finding.place.line;
  return allowance.whole_file || allowance.line == line ||
         (allowance.alone && allowance.line + 1 == line);
}

} // namespace

std::vector<Allowance> read_allowances(std::string_view text) {
  std::vector<Allowance> allowances;
  for (auto at = text.find(mark); at != npos; at = text.find(mark, at + 1)) {
    const auto begin = text.rfind(opening, at);
    const auto end = text.find("-->", at);
    if (begin == npos || end == npos ||
        !is_blank(
            text.substr(begin + opening.size(), at - begin - opening.size())))
      continue;
    auto said = text.substr(at + mark.size(), end - at - mark.size());
    const auto whole = said.find(everywhere);
    const auto line_begin = text.rfind('\n', begin) + 1; // npos + 1 is 0
    const auto line_end = std::min(text.find('\n', end), text.size());
    allowances.push_back(
        {static_cast<std::uint32_t>(
             1 + std::count(text.begin(),
                            text.begin() + static_cast<std::ptrdiff_t>(end),
                            '\n')),
         at + mark.size(),
         is_blank(text.substr(line_begin, begin - line_begin)) &&
             is_blank(text.substr(end + 3, line_end - end - 3)),
         whole != npos, names_in(said.substr(0, whole))});
  }
  return allowances;
}

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
