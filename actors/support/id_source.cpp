#include "actors/support/id_source.hpp"

#include <fmt/format.h>

namespace parlour::actors {

IdSource::IdSource(std::optional<std::uint64_t> seed)
    : seed_(seed), repeatable_(seed.value_or(0)) {}

// The device gives 32 bits at a time.
std::uint64_t IdSource::draw() {
  if (seed_)
    return repeatable_();
  const std::uint64_t high = device_();
  return high << 32 | device_();
}

SessionId IdSource::session_id() {
  const auto first = draw();
  return fmt::format("{:016x}{:016x}", first, draw());
}

std::uint64_t IdSource::session_seed() {
  return seed_ ? *seed_ : draw();
}

} // namespace parlour::actors
