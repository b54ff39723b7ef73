#include "adapters/files/name_pattern.hpp"

#include <cstddef>

#include "runtime/base/utf8.hpp"

namespace parlour::adapters {

namespace {

// The bytes of the character at `at`, in UTF-8.
std::size_t character(std::string_view text, std::size_t at) {
  std::size_t size = 1;
  while (at + size < text.size() && continues_code_point(text[at + size]))
    ++size;
  return size;
}

} // namespace

bool fits_pattern(std::string_view pattern, std::string_view name) {
  if (name.starts_with('.'))
    return false;
  std::size_t p = 0;
  std::size_t n = 0;
  auto star = std::string_view::npos; // the last one, which took until `taken`
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
