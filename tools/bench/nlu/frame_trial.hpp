// Makes sentences from an application's own grammars, with their meaning, and
// the same sentences as a speech recogniser might mishear them. The result is
// the same every time.
//
//  rule      a taxi to @Taxi.To [at @time {Time}] {act=inform} {topic=Taxi}
//  said      "a taxi to Marina Bay at nine thirty"
//  topic     Taxi
//  slots     To = Marina Bay, Time = 09:30
//  misheard  "taxi to Marine Bay at nine nine thirty"
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "runtime/message/understanding.hpp"

namespace parlour::tools {

struct FrameTrial {
  std::string said;
  std::string topic;
  // The values, as texts.
  std::map<std::string, std::string> slots;
};

// The time at which the sentences are said: "tomorrow" counts from it.
inline constexpr const char* frame_trial_time = "2026-11-21 09:00";

// Returns up to `count` sentences. They come from the rules with {act=…} and a
// topic, each rule in turn.
std::vector<FrameTrial> frame_trials(const UnderstandingModel& model,
                                     const ColumnReader& columns,
                                     std::size_t count);

// Changes about one word of ten: a letter is wrong, a small word is missing, a
// word is repeated, or the speaker says "er".
std::vector<FrameTrial> misheard(std::vector<FrameTrial> trials);

} // namespace parlour::tools
