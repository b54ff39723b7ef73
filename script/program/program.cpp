// Lookups by name, for the compiler and for names that are computed at run
// time.

#include "script/program/program.hpp"

#include <algorithm>

namespace parlour::script {

namespace {

// Linear, as applications are small and names are resolved while compiling.
template <class T>
std::uint32_t index_of(const std::vector<T>& all, std::string_view name) {
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i].name == name)
      return static_cast<std::uint32_t>(i);
  return no_id;
}

} // namespace

SlotId Topic::slot(std::string_view slot_name) const {
  return index_of(slots, slot_name);
}

bool Topic::has_part(TopicId topic) const {
  return std::ranges::any_of(
      slots, [&](const Slot& slot) { return slot.part == topic; });
}

bool Topic::has_rule(CodeId body) const {
  return std::any_of(rules.begin(), rules.end(),
                     [&](const Rule& rule) { return rule.body == body; });
}

TopicId Program::topic(std::string_view name) const {
  return index_of(topics, name);
}

StateId Program::state(std::string_view name) const {
  return index_of(states, name);
}

SourceLocation Program::place(Position position) const {
  if (position.file >= files.size())
    return {"", position.line, position.column};
  return {files[position.file], position.line, position.column};
}

bool has_private(const Program& program) {
  const auto is_private = [](const auto& one) { return one.is_private; };
  return std::ranges::any_of(program.variables, is_private) ||
         std::ranges::any_of(program.topics, [&](const Topic& topic) {
           return std::ranges::any_of(topic.slots, is_private);
         });
}

} // namespace parlour::script
