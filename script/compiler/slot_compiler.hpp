// Compiles a slot of a topic (engine rule 5.6).
#pragma once

#include "script/compiler/compilation.hpp"

namespace parlour::script {

// `slot` has its name already.
void compile_slot(const Element& element, Slot& slot,
                  const BodyContext& context, Compilation& compilation);

// The enumerator for the word of an attribute; the first one if it is missing.
template <class Enum>
Enum choice_of(const Element& element, const char* attribute,
               const std::vector<std::string>& words) {
  const auto value = element.value(attribute);
  for (std::size_t i = 0; i < words.size(); ++i)
    if (words[i] == value)
      return static_cast<Enum>(i);
  return Enum{};
}

// The attribute `match`: equal, prefix or contains.
Match match_of(const Element& element);

} // namespace parlour::script
