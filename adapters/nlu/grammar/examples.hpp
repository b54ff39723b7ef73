// Examples of a topic as rules: "I am [David](Visitor) from [Comptec]
// (Organisation)" is a rule whose places take any value of their slots, and so
// are its parts that end in a slot ("from …").
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "adapters/nlu/grammar/jsgf.hpp"
#include "runtime/base/understanding.hpp"

namespace parlour::adapters::nlu {

inline constexpr std::size_t most_example_bytes = 1000; // with its marks

struct ExampleRules {
  jsgf::Node whole;
  std::vector<jsgf::Node> parts;
};

// Marks that do not fit together and an example that is too long are errors;
// slots are not checked here.
ExampleRules example_rules(const TopicModel& topic, const std::string& example,
                           std::vector<Error>& errors);

} // namespace parlour::adapters::nlu
