#include "adapters/agents/wire/special_characters.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <tuple>

namespace parlour::adapters::agents {
namespace {

bool is_special(char c) {
  return c == ',' || c == '"' || c == '\n' || c == '\r' || c == '\\';
}

// Sixteen characters, which the compiler compares at once.
using Byte = std::uint8_t;
using Block = std::array<Byte, 16>;

constexpr Byte difference(Byte byte, char c) {
  return byte ^ static_cast<Byte>(c);
}

// A byte of `nearest` becomes 0 where there is a special character at its
// place.
void look_at(const char* at, Block& nearest) {
  Block block;
  std::memcpy(block.data(), at, block.size());
  for (std::size_t i = 0; i < block.size(); ++i) {
    auto least = nearest[i];
    least = std::min(least, difference(block[i], ','));
    least = std::min(least, difference(block[i], '"'));
    least = std::min(least, difference(block[i], '\n'));
    least = std::min(least, difference(block[i], '\r'));
    nearest[i] = std::min(least, difference(block[i], '\\'));
  }
}

} // namespace

bool has_special(std::string_view field) {
  constexpr auto size = std::tuple_size_v<Block>;
  if (field.size() < size)
    return std::ranges::any_of(field, is_special);
  Block nearest;
  nearest.fill(0xff);
  // The last block may begin before the end of the one before.
  const auto last = field.size() - size;
  for (std::size_t i = 0; i < last + size; i += size)
    look_at(field.data() + std::min(i, last), nearest);
  return std::ranges::count(nearest, 0) > 0;
}

} // namespace parlour::adapters::agents
