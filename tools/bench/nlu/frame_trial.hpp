// What is said to an application, made of its own grammars: sentences of its
// full rules, with what they mean; and the same as a recogniser hears them. The
// same ones every time.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "runtime/base/understanding.hpp"

namespace parlour::tools {

struct FrameTrial {
  std::string said;
  std::string topic;
  std::map<std::string, std::string> slots; // values
};

// The time at which they are said: "tomorrow" counts from it.
inline constexpr const char* frame_trial_time = "2026-11-21 09:00";

// Sentences are of the rules with {act=…} and a topic, each rule in turn.
std::vector<FrameTrial> frame_trials(const UnderstandingModel& model,
                                     const ColumnReader& columns,
                                     std::size_t count);

// Of ten words about one is misheard: a letter is another one, a small word is
// missing, a word comes twice, or somebody says "er".
std::vector<FrameTrial> misheard(std::vector<FrameTrial> trials);

} // namespace parlour::tools
