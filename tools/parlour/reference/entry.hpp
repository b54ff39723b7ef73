// Entry: what the reference tells of one element, function or role. It is made
// from the tables, and printed for a terminal or on a page.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace parlour::tools {

// "stands in", "<dialogue>"
struct Fact {
  std::string label;
  std::string text;
};

// An attribute, or a command or event of a role.
struct Detail {
  std::string name;
  std::string what; // "needed; a duration such as 200ms, 1.5s or 2m"
  std::string sentence;
};

struct Entry {
  std::string name;  // what it is asked for by
  std::string title; // "<var> among statements", "length(x)"
  std::string sentence;
  std::vector<Fact> facts{};
  std::vector<Detail> details{};
  std::string example{}; // lines, without the last line's end
};

// "a, b, c"
inline std::string listed(const std::vector<std::string>& words,
                          std::string_view between = ", ") {
  std::string text;
  for (const auto& word : words)
    text.append(text.empty() ? "" : between).append(word);
  return text;
}

} // namespace parlour::tools
