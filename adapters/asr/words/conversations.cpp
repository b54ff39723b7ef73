#include "adapters/asr/words/conversations.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>

namespace parlour::adapters::asr {

namespace {

// Of all files together.
constexpr std::size_t most_lines = 10'000;
constexpr std::string_view expected_slot = "expect slot ";

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos)
    return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

// "U: text" and "U(voice=rms): text"; empty for other lines.
std::string_view said_by_user(std::string_view line) {
  if (line.size() < 2 || line[0] != 'U' || (line[1] != ':' && line[1] != '('))
    return {};
  const auto colon = line.find(':', line[1] == '(' ? line.find(')') : 0);
  return colon == std::string_view::npos ? "" : trimmed(line.substr(colon + 1));
}

// "expect slot Appointment.Host = Jeffery Ho" gives a value of that slot;
// "unknown" is none.
void read_line(std::string_view line, Conversations& to) {
  if (const auto said = said_by_user(line); !said.empty())
    to.lines.emplace_back(said);
  if (!line.starts_with(expected_slot))
    return;
  const auto rest = line.substr(expected_slot.size());
  const auto sign = rest.find(" = ");
  if (sign == std::string_view::npos)
    return;
  const auto value = trimmed(rest.substr(sign + 3));
  if (value != "unknown" && !value.empty())
    to.values.emplace_back(trimmed(rest.substr(0, sign)), value);
}

} // namespace

void read_conversation(std::string_view text, Conversations& to) {
  while (!text.empty() && to.lines.size() < most_lines) {
    const auto end = std::min(text.find('\n'), text.size());
    read_line(trimmed(text.substr(0, end)), to);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

// Sorted, so that equal folders give equal models on every machine.
Conversations read_conversations(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (std::filesystem::directory_iterator at(folder, error), end;
       !error && at != end; at.increment(error))
    if (at->path().extension() == ".txt")
      files.push_back(at->path());
  std::ranges::sort(files);
  Conversations all;
  for (const auto& file : files) {
    std::ifstream stream(file);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    read_conversation(text, all);
  }
  return all;
}

} // namespace parlour::adapters::asr
