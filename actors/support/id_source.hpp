// IdSource: session ids that cannot be guessed, and seeds for what is random in
// scripts; from a seed, the same ones each time.
#pragma once

#include <optional>
#include <random>

#include "runtime/message/message.hpp"

namespace parlour::actors {

// Used by one thread at a time.
// An id is a secret: who knows it can speak in that session (engine rule 1.5).
class IdSource {
public:
  explicit IdSource(std::optional<std::uint64_t> seed);

  SessionId session_id(); // 32 hexadecimal digits
  // The seed given, for each session the same: what a session does may not
  // hang on how many there were before it.
  std::uint64_t session_seed();

private:
  std::uint64_t draw();

  std::optional<std::uint64_t> seed_;
  std::mt19937_64 repeatable_;
  std::random_device device_;
};

} // namespace parlour::actors
