#include "script/source/source.hpp"

#include <algorithm>

namespace parlour::script {

namespace {

char small(char letter) {
  return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter | 0x20)
                                        : letter;
}

} // namespace

bool same_name(std::string_view a, std::string_view b) {
  if (a.size() != b.size() || a.empty())
    return a.size() == b.size();
  return small(a.front()) == small(b.front()) && a.substr(1) == b.substr(1);
}

bool Element::is(std::string_view other) const {
  return same_name(name, other);
}

const Attribute* Element::attribute(std::string_view attribute_name) const {
  auto found =
      std::find_if(attributes.begin(), attributes.end(),
                   [&](const auto& one) { return one.name == attribute_name; });
  return found == attributes.end() ? nullptr : &*found;
}

std::string Element::value(std::string_view attribute_name) const {
  const auto* found = attribute(attribute_name);
  return found ? found->value : std::string();
}

const Element* Element::child(std::string_view child_name) const {
  auto found =
      std::find_if(children.begin(), children.end(),
                   [&](const auto& one) { return one.is(child_name); });
  return found == children.end() ? nullptr : &*found;
}

std::string collapsed(std::string_view text) {
  std::string result;
  for (const char letter : text) {
    const bool blank =
        letter == ' ' || letter == '\t' || letter == '\n' || letter == '\r';
    if (!blank)
      result += letter;
    else if (!result.empty() && result.back() != ' ')
      result += ' ';
  }
  if (result.ends_with(' '))
    result.pop_back();
  return result;
}

} // namespace parlour::script
