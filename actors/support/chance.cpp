#include "actors/support/chance.hpp"

#include <fmt/format.h>

namespace parlour::actors {

Chance::Chance(std::optional<std::uint64_t> seed)
    : seed_(seed), repeatable_(seed.value_or(0)) {}

std::uint64_t Chance::draw() {
  if (seed_)
    return repeatable_();
  const std::uint64_t high = device_();
  return high << 32 | device_();
}

SessionId Chance::session_id() {
  const auto first = draw();
  return fmt::format("{:016x}{:016x}", first, draw());
}

std::uint64_t Chance::session_seed() {
  return seed_ ? *seed_ : draw();
}

} // namespace parlour::actors
