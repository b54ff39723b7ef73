// The order in which examples are learnt: different in each round, but the same
// in every training, so that results can be repeated.
#pragma once

#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "runtime/base/random.hpp"

namespace parlour::adapters::nlu {

// A Fisher-Yates shuffle with a fixed seed.
class ShuffledOrder {
public:
  explicit ShuffledOrder(std::size_t size) : order_(size), random_(1) {
    std::iota(order_.begin(), order_.end(), 0);
  }

  // The order of the next round. The reference is valid until the next call.
  const std::vector<std::size_t>& next() {
    for (auto at = order_.size(); at > 1; --at)
      std::swap(order_[at - 1], order_[random_.next() % at]);
    return order_;
  }

private:
  std::vector<std::size_t> order_;
  Random random_;
};

} // namespace parlour::adapters::nlu
