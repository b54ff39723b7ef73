// WireNumbers: correlations as an agent sees them. Those of the platform count
// in each conversation from 1; an agent talks with many conversations at once,
// so it is given numbers that no two messages share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>

#include "runtime/message/message.hpp"

namespace parlour::adapters::agents {

// For one thread at a time.
class WireNumbers {
public:
  // Who waits for the answer to a message.
  struct Asker {
    SessionId session;
    Correlation correlation = 0;
  };
  // Of more messages than this, the oldest is forgotten: its answer is then an
  // event of its own.
  static constexpr std::size_t max_askers = 10'000;

  // The number for a message of this asker, from 1.
  std::uint64_t number_for(Asker asker);
  // A message may have several answers, so that its asker stays known. Null: no
  // message had the number, or it was forgotten.
  const Asker* find(std::uint64_t number) const;

private:
  std::uint64_t last_ = 0;
  std::map<std::uint64_t, Asker> askers_;
};

} // namespace parlour::adapters::agents
