// Rewrites the robot's words in a conversation file and leaves everything else
// as it was: comments, blanks and line ends. For `parlour test --update`.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace parlour::tools {

// Other words that the robot said at an `R:`.
struct Rewording {
  std::uint32_t line = 0; // of the file, counted from 1
  std::string before;
  std::string after;

  bool operator==(const Rewording&) const = default;
};

// The text with the new words. `rewordings` must be sorted by line. Pure.
std::string reworded(std::string_view text,
                     const std::vector<Rewording>& rewordings);

} // namespace parlour::tools
