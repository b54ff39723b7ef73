#include "adapters/agents/component/wire_numbers.hpp"

#include <utility>

namespace parlour::adapters::agents {

std::uint64_t WireNumbers::number_for(Asker asker) {
  askers_.emplace_hint(askers_.end(), ++last_, std::move(asker));
  if (askers_.size() > max_askers)
    askers_.erase(askers_.begin());
  return last_;
}

const WireNumbers::Asker* WireNumbers::find(std::uint64_t number) const {
  const auto found = askers_.find(number);
  return found == askers_.end() ? nullptr : &found->second;
}

} // namespace parlour::adapters::agents
