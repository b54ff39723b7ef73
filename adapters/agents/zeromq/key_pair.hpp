// Keys for CURVE, with which ZeroMQ encrypts and authenticates
// (adapters/agents/PROTOCOL.md 2.4).
#pragma once

#include <cstddef>
#include <string>

#include "runtime/base/error.hpp"

namespace parlour::adapters::agents {

// The characters of a key as Z85 text.
inline constexpr std::size_t key_characters = 40;

struct KeyPair {
  std::string public_key;
  std::string secret_key;
};

// Makes a new pair. The error, of kind Settings, says that this libzmq was
// built without CURVE. Thread-safe.
Expected<KeyPair> new_key_pair();

} // namespace parlour::adapters::agents
