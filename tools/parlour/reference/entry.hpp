// Entry: what the reference says about one element, built-in function or role.
// x_entry.hpp makes entries from the tables; entry_text.hpp prints them for a
// terminal, entry_page.hpp as Markdown.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace parlour::tools {

// A labelled line: "stands in", "<dialogue>".
struct Fact {
  std::string label;
  std::string text;
};

// One row of the entry's table: an attribute of an element, or a command or an
// event of a role.
struct Detail {
  std::string name;
  // "needed; a duration such as 200ms, 1.5s or 2m"
  std::string what;
  std::string sentence;
};

// Plain data; entries are built once and copied.
struct Entry {
  std::string name;     // what users look up
  std::string title;    // heading: "length(x)"
  std::string sentence; // what it is
  std::vector<Fact> facts{};
  std::vector<Detail> details{};
  std::string example{}; // without the last line end
};

// The words joined: "a, b, c".
inline std::string listed(const std::vector<std::string>& words,
                          std::string_view between = ", ") {
  std::string text;
  for (const auto& word : words)
    text.append(text.empty() ? "" : between).append(word);
  return text;
}

} // namespace parlour::tools
