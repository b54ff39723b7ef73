#include "adapters/http/policy/rate_limit.hpp"

#include <algorithm>

namespace parlour::adapters::http {

bool RateLimit::admit(Moment now) {
  const std::chrono::duration<double> passed = now - last_;
  left_ = std::min(per_second_, left_ + passed.count() * per_second_);
  last_ = now;
  if (left_ < 1)
    return false;
  left_ -= 1;
  return true;
}

} // namespace parlour::adapters::http
