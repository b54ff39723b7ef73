#include "script/well_formed.hpp"

#include <cctype>

namespace parlour::script {

namespace {

constexpr auto npos = std::string_view::npos;

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
