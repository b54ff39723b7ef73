// Rewording: a conversation file with other words in the robot's mouth, all
// else as it was: comments, blanks, the ends of its lines.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace parlour::tools {

struct Rewording {
  std::uint32_t line = 0; // of the file, an "R:"
  std::string before;
  std::string after;

  bool operator==(const Rewording&) const = default;
};

// `rewordings` in the order of their lines.
std::string reworded(std::string_view text,
                     const std::vector<Rewording>& rewordings);

} // namespace parlour::tools
