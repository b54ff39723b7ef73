#include "runtime/base/text/comma_list.hpp"

#include <algorithm>

namespace parlour {

namespace {

constexpr std::string_view blanks = " \t\r\n";

} // namespace

std::vector<std::string> split_at_commas(std::string_view text) {
  std::vector<std::string> parts;
  for (std::size_t at = 0; at <= text.size();) {
    const auto end = std::min(text.find(',', at), text.size());
    const auto part = text.substr(at, end - at);
    if (const auto first = part.find_first_not_of(blanks);
        first != std::string_view::npos)
      parts.emplace_back(
          part.substr(first, part.find_last_not_of(blanks) - first + 1));
    at = end + 1;
  }
  return parts;
}

} // namespace parlour
