#include "actors/support/privacy/shared_secrets.hpp"

#include <algorithm>
#include <cctype>

namespace parlour::actors {

namespace {

// What masking skips between digits.
bool may_be_skipped(char c) {
  return c == ' ' || c == '-' || c == '.';
}

// The first bytes without those, in lower case: the same for a secret and for
// every way in which it occurs.
std::string beginning_of(std::string_view text, std::size_t most) {
  std::string bytes;
  for (std::size_t i = 0; i < text.size() && bytes.size() < most; ++i)
    if (!may_be_skipped(text[i]))
      bytes +=
          static_cast<char>(std::tolower(static_cast<unsigned char>(text[i])));
  return bytes;
}

// Without blanks at its ends, as Secrets keeps it.
std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n";
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos)
    return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

} // namespace

void SharedSecrets::add(std::string_view text) {
  const auto secret = trimmed(text);
  if (secret.empty())
    return;
  auto beginning = beginning_of(secret, max_beginning);
  auto& alike = by_beginning_[beginning];
  if (alike.empty())
    ++lengths_[beginning.size()];
  ++alike[std::string(secret)];
}

void SharedSecrets::remove(std::string_view text) {
  const auto secret = trimmed(text);
  const auto alike = by_beginning_.find(beginning_of(secret, max_beginning));
  if (alike == by_beginning_.end())
    return;
  const auto found = alike->second.find(secret);
  if (found == alike->second.end() || --found->second > 0)
    return;
  alike->second.erase(found);
  if (!alike->second.empty())
    return;
  --lengths_[alike->first.size()];
  by_beginning_.erase(alike);
}

void SharedSecrets::collect(std::string_view beginning, Secrets& to) const {
  if (lengths_[beginning.size()] == 0)
    return;
  const auto alike = by_beginning_.find(beginning);
  if (alike != by_beginning_.end())
    for (const auto& secret : alike->second)
      to.add(secret.first);
}

// Only those that can occur in the text are looked for. For each place of the
// text, and each length that a beginning may have, one lookup finds the
// candidates; Secrets then masks only those. A secret of nothing but blanks,
// hyphens and dots has the empty beginning and is always a candidate.
std::string SharedSecrets::masked(std::string_view text) const {
  Secrets near;
  collect({}, near);
  const auto letters = beginning_of(text, text.size());
  for (std::size_t at = 0; at < letters.size(); ++at)
    for (std::size_t length = 1;
         length <= std::min(max_beginning, letters.size() - at); ++length)
      collect(std::string_view(letters).substr(at, length), near);
  return near.empty() ? std::string(text) : near.masked(text);
}

} // namespace parlour::actors
