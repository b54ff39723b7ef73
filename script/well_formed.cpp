#include "script/well_formed.hpp"

#include <algorithm>
#include <vector>

namespace parlour::script {

namespace {

constexpr auto npos = std::string_view::npos;

bool is_name_end(char letter) {
  return std::string_view(" \t\r\n/>=<").find(letter) != npos;
}

std::string_view name_at(std::string_view text, std::size_t offset) {
  auto end = offset;
  while (end < text.size() && !is_name_end(text[end]))
    ++end;
  return text.substr(offset, end - offset);
}

// Behind a comment, CDATA section, declaration or instruction; npos where it
// does not end; `offset` itself where none of these begins there.
std::size_t skip_special(std::string_view text, std::size_t offset) {
  static constexpr std::pair<std::string_view, std::string_view> kinds[] = {
      {"<!--", "-->"}, {"<![CDATA[", "]]>"}, {"<?", "?>"}, {"<!", ">"}};
  for (const auto& [begin, end] : kinds) {
    if (!text.substr(offset).starts_with(begin))
      continue;
    const auto found = text.find(end, offset + begin.size());
    return found == npos ? npos : found + end.size();
  }
  return offset;
}

// The `>` of the tag that begins at `offset`, quoted values aside.
std::size_t end_of_tag(std::string_view text, std::size_t offset) {
  char quote = 0;
  for (auto i = offset; i < text.size(); ++i) {
    if (quote)
      quote = text[i] == quote ? '\0' : quote;
    else if (text[i] == '"' || text[i] == '\'')
      quote = text[i];
    else if (text[i] == '>')
      return i;
  }
  return npos;
}

// Whether an entity that XML knows begins at the `&` there.
bool is_entity(std::string_view text) {
  for (const auto* known : {"&lt;", "&gt;", "&amp;", "&quot;", "&apos;"})
    if (text.starts_with(known))
      return true;
  if (!text.starts_with("&#"))
    return false;
  text.remove_prefix(2);
  const bool hexadecimal = text.starts_with('x');
  const auto digits =
      std::string_view(hexadecimal ? "0123456789abcdefABCDEF" : "0123456789");
  text.remove_prefix(hexadecimal ? 1 : 0);
  const auto end = text.find_first_not_of(digits);
  return end != 0 && end != npos && text[end] == ';';
}

} // namespace

TagProblem find_tag_problem(std::string_view text) {
  std::vector<OpenElement> open;
  auto problem = [&](std::size_t offset, std::string_view found) {
    return TagProblem{offset, std::string(found),
                      open.empty() ? OpenElement{} : open.back()};
  };
  for (auto i = text.find('<'); i != npos; i = text.find('<', i)) {
    if (const auto next = skip_special(text, i); next != i) {
      i = next;
      continue;
    }
    const bool closes = text.substr(i).starts_with("</");
    const auto name = name_at(text, i + (closes ? 2 : 1));
    const auto end = end_of_tag(text, i + 1);
    if (end == npos)
      return problem(i, closes ? name : "");
    if (closes && (open.empty() || open.back().name != name))
      return problem(i, name);
    if (closes)
      open.pop_back();
    else if (text[end - 1] != '/')
      open.push_back({std::string(name), i});
    i = end;
  }
  return open.empty() ? TagProblem{npos, "", {}} : problem(text.size(), "");
}

void check_characters(
    std::string_view text, std::size_t offset, bool in_attribute,
    const std::function<void(std::size_t, std::string)>& report) {
  const auto end = text.find(in_attribute ? text[offset - 1] : '<', offset);
  const auto part = text.substr(0, end);
  for (auto i = part.find('&', offset); i != npos; i = part.find('&', i + 1))
    if (!is_entity(part.substr(i, 12)))
      report(i, "'&' must be written &amp; (in an expression: and)");
  if (in_attribute)
    for (auto i = part.find('<', offset); i != npos; i = part.find('<', i + 1))
      report(i, "'<' in a value must be written &lt; (in an expression: lt)");
}

} // namespace parlour::script
