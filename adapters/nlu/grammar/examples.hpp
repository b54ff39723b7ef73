// Turns an example of a topic into rules. "I am [David](Visitor) from [Comptec]
// (Organisation)" becomes a rule that takes any value of the slots in the
// marked places. Each part that ends in a slot ("from …") becomes a rule as
// well.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "adapters/nlu/grammar/jsgf.hpp"
#include "runtime/message/understanding.hpp"

namespace parlour::adapters::nlu {

// With its marks.
inline constexpr std::size_t max_example_bytes = 1000; // with its marks

// The rule of the whole example, and those of its parts.
struct ExampleRules {
  jsgf::Node whole;
  std::vector<jsgf::Node> parts;
};

// Errors: marks that do not fit together, and an example that is too long.
// Whether the slots exist is not checked here.
ExampleRules example_rules(const TopicModel& topic, const std::string& example,
                           std::vector<Error>& errors);

} // namespace parlour::adapters::nlu
