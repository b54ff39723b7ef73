#include "script/well_formed.hpp"

#include <cctype>

namespace parlour::script {

namespace {

constexpr auto npos = std::string_view::npos;

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

XmlSlip lone_ampersand(std::string_view text, std::size_t offset) {
  if (text.substr(offset).starts_with("&&"))
    return {offset, 2,
            "'&&' must be written &amp;&amp; (in an expression: and)",
            "&amp;&amp;"};
  auto end = offset + 1;
  while (end < text.size() &&
         std::isalnum(static_cast<unsigned char>(text[end])))
    ++end;
  if (end > offset + 1 && end < text.size() && text[end] == ';') {
    const auto name = std::string(text.substr(offset, end + 1 - offset));
    return {offset, name.size(),
            "there is no " + name + " in XML: write the character itself"};
  }
  return {offset, 1, "'&' must be written &amp; (in an expression: and)",
          "&amp;"};
}

} // namespace

std::size_t find_text_outside(std::string_view text) {
  int depth = 0;
  for (std::size_t i = 0; i < text.size();) {
    i = depth == 0 ? text.find_first_not_of(" \t\r\n", i) : text.find('<', i);
    if (i == npos)
      return npos;
    if (text[i] != '<')
      return i;
    if (const auto next = skip_special(text, i); next != i) {
      i = next;
      continue;
    }
    const auto end = end_of_tag(text, i + 1);
    if (end == npos)
      return npos;
    if (text[i + 1] == '/')
      --depth;
    else if (text[end - 1] != '/')
      ++depth;
    i = end + 1;
  }
  return npos;
}

void check_characters(std::string_view text, std::size_t offset,
                      bool in_attribute,
                      const std::function<void(const XmlSlip&)>& report) {
  const char end = in_attribute ? text[offset - 1] : '<';
  for (auto i = offset; i < text.size() && text[i] != end; ++i) {
    if (text[i] == '&' && !is_entity(text.substr(i, 12))) {
      auto slip = lone_ampersand(text, i);
      i += slip.length - 1;
      report(slip);
    }
    if (in_attribute && text[i] == '<')
      report({i, 1,
              "'<' in a value must be written &lt; (in an expression: lt)",
              "&lt;"});
  }
}

} // namespace parlour::script
