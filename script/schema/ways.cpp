#include "script/schema/ways.hpp"

#include <algorithm>

namespace parlour::script {

namespace {

// The way of one form: its attributes and all that are in no form.
Way way_of(const ElementRule& rule, const AttributeForm& form) {
  Way way;
  for (const auto& attribute : rule.attributes) {
    const auto* word = find_word(form, attribute.name);
    if (!word && rule.is_in_a_form(attribute.name))
      continue;
    way.attributes.push_back(
        {attribute, word ? word->required : attribute.required});
    if (word && !word->values.empty())
      way.attributes.back().rule.words = word->values;
  }
  return way;
}

// Divides a way by an EITHER: without the attribute, and with it but without
// the children.
std::vector<Way> divided(Way way, const Either& either) {
  const auto found =
      std::ranges::find_if(way.attributes, [&](const auto& attribute) {
        return attribute.rule.name == either.attribute;
      });
  if (found == way.attributes.end())
    return {std::move(way)};
  std::vector<Way> ways;
  if (!found->required) {
    ways.push_back(way);
    auto& others = ways.back().attributes;
    others.erase(others.begin() + (found - way.attributes.begin()));
  }
  found->required = true;
  way.without.push_back(either.child);
  ways.push_back(std::move(way));
  return ways;
}

} // namespace

bool Way::leaves_out(const std::string& child) const {
  return std::ranges::count(without, child) != 0;
}

// One way for each form, divided by each EITHER in turn.
std::vector<Way> ways_of(const ElementRule& rule) {
  std::vector<Way> ways;
  for (const auto& form : rule.forms)
    ways.push_back(way_of(rule, form));
  if (ways.empty())
    ways.push_back(way_of(rule, {}));
  for (const auto& either : rule.either) {
    std::vector<Way> all;
    for (auto& way : ways)
      std::ranges::move(divided(std::move(way), either),
                        std::back_inserter(all));
    ways = std::move(all);
  }
  return ways;
}

} // namespace parlour::script
