// A hash of a text: 64-bit FNV-1a, which is the same on each machine.
#pragma once

#include <cstdint>
#include <string_view>

namespace parlour::adapters::nlu {

// Continues `hash`, that of a text before.
constexpr std::uint64_t hash_of(std::string_view bytes,
                                std::uint64_t hash = 0xcbf29ce484222325) {
  for (const char byte : bytes)
    hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
  return hash;
}

} // namespace parlour::adapters::nlu
