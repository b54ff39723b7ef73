#include "adapters/http/rules/rules_xml.hpp"

#include <algorithm>
#include <utility>

#include <pugixml.hpp>

namespace parlour::adapters::http {

namespace {

bool is_among(std::initializer_list<std::string_view> names,
              std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string listed(std::initializer_list<std::string_view> first,
                   std::initializer_list<std::string_view> second) {
  std::string text;
  for (const auto& names : {first, second})
    for (const auto& name : names)
      text += (text.empty() ? "" : ", ") + std::string(name);
  return text.empty() ? "none" : text;
}

} // namespace

// Counted anew each time: only mistakes and few elements ask for it.
std::uint32_t RulesXml::line_of(std::ptrdiff_t offset) const {
  const auto end = std::clamp<std::ptrdiff_t>(
      offset, 0, static_cast<std::ptrdiff_t>(text_.size()));
  const auto before = text_.substr(0, static_cast<std::size_t>(end));
  return static_cast<std::uint32_t>(
      std::count(before.begin(), before.end(), '\n') + 1);
}

std::uint32_t RulesXml::line_of(const pugi::xml_node& node) const {
  return line_of(node.offset_debug());
}

SourceLocation RulesXml::place_of(const pugi::xml_node& node) const {
  return {file_, line_of(node), 1};
}

void RulesXml::error(const pugi::xml_node& node, std::string message) {
  error(line_of(node), std::move(message));
}

void RulesXml::error(std::uint32_t line, std::string message) {
  errors_.push_back(
      {ErrorKind::settings, std::move(message), {file_, line, 1}});
}

// Unknown attributes are mistakes, too: "retries" for "retry" must not be
// ignored.
bool RulesXml::check_attributes(
    const pugi::xml_node& node, std::initializer_list<std::string_view> needed,
    std::initializer_list<std::string_view> optional) {
  const auto before = errors_.size();
  const auto begin = "<" + std::string(node.name()) + "> ";
  for (const auto attribute : node.attributes())
    if (!is_among(needed, attribute.name()) &&
        !is_among(optional, attribute.name()))
      error(node, begin + "has no attribute '" + attribute.name() +
                      "'; there are " + listed(needed, optional));
  for (const auto& name : needed)
    if (std::string_view(node.attribute(std::string(name).c_str()).value())
            .empty())
      error(node, begin + "needs the attribute '" + std::string(name) + "'");
  return errors_.size() == before;
}

void RulesXml::unknown(const pugi::xml_node& node, const std::string& known) {
  error(node, "<" + std::string(node.name()) + "> is not known in <" +
                  node.parent().name() + ">; there are " + known);
}

// Readers do not report in the order of the lines: a command is checked after
// its parts.
std::vector<Error> RulesXml::take_errors() {
  std::stable_sort(errors_.begin(), errors_.end(),
                   [](const Error& left, const Error& right) {
                     return left.place.line < right.place.line;
                   });
  return std::exchange(errors_, {});
}

// Texts and CDATA that follow each other are one text.
std::string text_of(const pugi::xml_node& node) {
  std::string text;
  for (const auto child : node.children())
    if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata)
      text += child.value();
  constexpr auto blanks = " \t\r\n";
  text.erase(0, std::min(text.find_first_not_of(blanks), text.size()));
  text.erase(text.find_last_not_of(blanks) + 1);
  return text;
}

} // namespace parlour::adapters::http
