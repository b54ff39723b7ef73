#include "runtime/base/rate_limit.hpp"

#include <algorithm>

namespace parlour {

bool RateLimit::admit(Moment now) {
  const std::chrono::duration<double> passed = now - last_;
  left_ = std::min(at_once_, left_ + passed.count() * per_second_);
  last_ = now;
  if (left_ < 1)
    return false;
  left_ -= 1;
  return true;
}

} // namespace parlour
