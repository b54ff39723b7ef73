// The words of a text.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace parlour {

// The parts between blanks, tabs and line ends; never empty ones.
inline std::vector<std::string> split_words(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n\v\f";
  std::vector<std::string> words;
  for (auto at = text.find_first_not_of(blanks);
       at != std::string_view::npos;) {
    const auto end = std::min(text.find_first_of(blanks, at), text.size());
    words.emplace_back(text.substr(at, end - at));
    at = text.find_first_not_of(blanks, end);
  }
  return words;
}

} // namespace parlour
