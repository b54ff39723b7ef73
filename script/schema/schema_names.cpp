// Names and texts that both schemas use in the same form.

#include "script/schema/schema_names.hpp"

#include <algorithm>
#include <cctype>

namespace parlour::script {

std::string schema_name(const ElementRule& rule) {
  const auto index = &rule - element_table().data();
  return "e" + std::to_string(index) + "." +
         (rule.name == "*" ? "any" : rule.name);
}

std::vector<std::string> spellings(const std::string& name) {
  const auto first = static_cast<unsigned char>(name.front());
  auto other = name;
  other.front() = static_cast<char>(std::islower(first) ? std::toupper(first)
                                                        : std::tolower(first));
  return {name, other};
}

std::vector<const ElementRule*>
rows_within(const std::vector<std::string>& within) {
  std::vector<const ElementRule*> rows;
  for (const auto& rule : element_table())
    if (std::any_of(rule.in.begin(), rule.in.end(), [&](const auto& one) {
          return std::find(within.begin(), within.end(), one) != within.end();
        }))
      rows.push_back(&rule);
  return rows;
}

bool is_free(const ElementRule& rule) {
  return std::find(rule.holds.begin(), rule.holds.end(), "free") !=
         rule.holds.end();
}

// The same forms as attribute_check.cpp, as far as a pattern can say them.
std::string_view pattern_of(AttributeKind kind) {
  switch (kind) {
  case AttributeKind::name:
    return "[_\\p{L}][_\\p{L}\\p{M}\\p{N}]*";
  case AttributeKind::integer:
    return "[0-9]+";
  case AttributeKind::size:
    return "[0-9]+(KB|MB|GB)?";
  case AttributeKind::duration:
    return ".*\\{.*|\\s*[0-9]+(\\.[0-9]+)?\\s*(ms|s|m|h)";
  default:
    return {};
  }
}

// A boolean is a choice of two words.
std::vector<std::string> words_of(const AttributeRule& rule) {
  if (rule.kind == AttributeKind::boolean)
    return {"true", "false"};
  return rule.kind == AttributeKind::choice ? rule.words
                                            : std::vector<std::string>();
}

std::string documentation(const ElementRule& rule) {
  return rule.sentence + (rule.available ? "" : " (not available yet)");
}

std::string documentation(const AttributeRule& rule) {
  return rule.sentence + " (" + std::string(sentence_of(rule.kind)) + ")";
}

} // namespace parlour::script
