// WordHash: a fast hash of words of eight bytes, the same in every build and on
// every machine. It does not protect against somebody who constructs two inputs
// with the same hash.
#pragma once

#include <bit>
#include <cstdint>
#include <string_view>

namespace parlour {

class WordHash {
public:
  void add(std::uint64_t value) {
    state_ = (std::rotl(state_, 23) ^ value) * 0x9e3779b97f4a7c15;
    state_ ^= state_ >> 29;
  }
  void add(std::string_view text) {
    add(std::uint64_t{text.size()});
    for (; text.size() > 8; text.remove_prefix(8))
      add(word(text.substr(0, 8)));
    add(word(text));
  }
  std::uint64_t value() const {
    return state_;
  }

private:
  // Lowest byte first on every machine.
  static std::uint64_t word(std::string_view text) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < text.size(); ++i)
      value |= std::uint64_t{static_cast<unsigned char>(text[i])} << (8 * i);
    return value;
  }

  std::uint64_t state_ = 0x243f6a8885a308d3;
};

} // namespace parlour
