#include "adapters/files/name_pattern.hpp"

#include <cstddef>

#include "runtime/base/text/utf8.hpp"

namespace parlour::adapters {

namespace {

// The bytes of the UTF-8 character at a position.
std::size_t character(std::string_view text, std::size_t at) {
  std::size_t size = 1;
  while (at + size < text.size() && continues_code_point(text[at + size]))
    ++size;
  return size;
}

} // namespace

// Matches from left to right. After a mismatch the last '*' takes one more
// character and matching goes on behind it. Earlier ones need not be tried
// again: if the rest fits behind some position, a later '*' finds it as well.
bool fits_pattern(std::string_view pattern, std::string_view name) {
  if (name.starts_with('.'))
    return false;
  std::size_t p = 0;
  std::size_t n = 0;
  // The position of the last '*', and the end of what it has taken so far.
  auto star = std::string_view::npos;
  std::size_t taken = 0;
  while (n < name.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      taken = n;
    } else if (p < pattern.size() && pattern[p] == '?') {
      ++p;
      n += character(name, n);
    } else if (p < pattern.size() && pattern[p] == name[n]) {
      ++p;
      ++n;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      taken += character(name, taken);
      n = taken;
    } else {
      return false;
    }
  }
  while (p < pattern.size() && pattern[p] == '*')
    ++p;
  return p == pattern.size();
}

} // namespace parlour::adapters
