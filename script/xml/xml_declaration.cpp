// The declaration may be missing. If it is there, it has the form
//
//   <?xml version="1.0" encoding="UTF-8" standalone="yes"?>
//
// with the last two parts optional and in this order.

#include "script/xml/xml_declaration.hpp"

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

namespace parlour::script {

namespace {

constexpr auto npos = std::string_view::npos;
constexpr std::string_view blanks = " \t\r\n";
constexpr std::string_view opening = "<?xml";
constexpr std::string_view usual = R"(<?xml version="1.0" encoding="UTF-8"?>)";

bool same_letters(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) {
    return std::tolower(static_cast<unsigned char>(x)) ==
           std::tolower(static_cast<unsigned char>(y));
  });
}

// One pseudo-attribute of the declaration, such as version="1.0".
struct Part {
  std::string_view name;
  std::string_view value;
  std::size_t value_offset = 0;
};

// The parts between "<?xml" and "?>"; nothing if there is anything else.
std::optional<std::vector<Part>> parts_of(std::string_view inside,
                                          std::size_t offset) {
  std::vector<Part> parts;
  std::size_t at = 0;
  for (;;) {
    const auto begin = inside.find_first_not_of(blanks, at);
    if (begin == npos)
      return parts;
    const auto end = inside.find_first_of("= \t\r\n", begin);
    const auto equals =
        inside.find_first_not_of(blanks, std::min(end, inside.size()));
    if (begin == at || equals == npos || inside[equals] != '=')
      return {};
    const auto quote = inside.find_first_not_of(blanks, equals + 1);
    if (quote == npos || (inside[quote] != '"' && inside[quote] != '\''))
      return {};
    const auto close = inside.find(inside[quote], quote + 1);
    if (close == npos)
      return {};
    parts.push_back({inside.substr(begin, end - begin),
                     inside.substr(quote + 1, close - quote - 1),
                     offset + quote + 1});
    at = close + 1;
  }
}

// 1.0 and later minor versions, as the recommendation allows.
bool is_version(std::string_view value) {
  return value.size() > 2 && value.starts_with("1.") &&
         std::all_of(value.begin() + 2, value.end(), [](char c) {
           return std::isdigit(static_cast<unsigned char>(c)) != 0;
         });
}

// Whether the parts are in the order of the standard. The version is required,
// the others are optional.
bool are_in_order(const std::vector<Part>& parts) {
  constexpr std::string_view order[] = {"version", "encoding", "standalone"};
  std::size_t next = 0;
  for (const auto& part : parts) {
    while (next < std::size(order) && order[next] != part.name)
      ++next;
    if (next++ == std::size(order))
      return false;
  }
  return !parts.empty() && parts[0].name == "version";
}

// Only UTF-8 is read. For a file of ASCII characters the encoding can simply be
// corrected, because it is the same in UTF-8.
std::optional<XmlMistake> wrong_part(const Part& part, bool is_ascii) {
  const auto shown = std::string(part.value);
  const auto mistake = [&](std::string message,
                           std::optional<std::string> replacement) {
    return XmlMistake{part.value_offset, part.value.size(), std::move(message),
                      std::move(replacement)};
  };
  if (part.name == "version" && !is_version(part.value))
    return mistake("there is no version '" + shown + "' of XML; expected 1.0",
                   "1.0");
  if (part.name == "standalone" && part.value != "yes" && part.value != "no")
    return mistake(
        "standalone is yes or no, not '" + shown + "'; it may be left out", {});
  if (part.name == "encoding" && !same_letters(part.value, "UTF-8"))
    return mistake("this file says that it is written in '" + shown +
                       "'; save it as UTF-8 and write encoding=\"UTF-8\"",
                   is_ascii ? std::optional<std::string>("UTF-8")
                            : std::nullopt);
  return {};
}

bool is_ascii(std::string_view text) {
  return std::all_of(text.begin(), text.end(),
                     [](char byte) { return (byte & 0x80) == 0; });
}

} // namespace

bool is_xml_declaration(std::string_view text) {
  return text.size() > opening.size() &&
         same_letters(text.substr(0, opening.size()), opening) &&
         (blanks.find(text[opening.size()]) != npos ||
          text[opening.size()] == '?');
}

std::optional<XmlMistake> declaration_fault(std::string_view text,
                                            std::size_t offset) {
  const auto begin = offset + opening.size();
  const auto close = std::min(text.find("?>", begin), text.size());
  const auto parts = parts_of(text.substr(begin, close - begin), begin);
  if (!text.substr(offset).starts_with(opening) || !parts ||
      !are_in_order(*parts))
    return XmlMistake{offset, std::min(close + 2, text.size()) - offset,
                      "the XML declaration is written " + std::string(usual) +
                          "; it may be left out",
                      std::string(usual)};
  for (const auto& part : *parts)
    if (auto mistake = wrong_part(part, is_ascii(text)))
      return mistake;
  return {};
}

} // namespace parlour::script
