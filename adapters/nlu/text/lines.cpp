#include "adapters/nlu/text/lines.hpp"

#include <algorithm>

namespace parlour::adapters::nlu {

namespace {

constexpr std::string_view blanks = " \t\r";

std::string_view trimmed(std::string_view line) {
  line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
  return line.substr(0, line.find_last_not_of(blanks) + 1);
}

} // namespace

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const auto end = std::min(text.find('\n'), text.size());
    const auto line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (const auto words = trimmed(line.substr(0, line.find('#')));
        !words.empty())
      lines.push_back(words);
  }
  return lines;
}

} // namespace parlour::adapters::nlu
