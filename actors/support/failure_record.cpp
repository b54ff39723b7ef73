#include "actors/support/failure_record.hpp"

#include <algorithm>

namespace parlour::actors {

FailureRecord::Verdict FailureRecord::failed(Timestamp now) {
  ++count_;
  const bool returned =
      last_rest_ > Milliseconds::zero() && now < returns_ + window.count();
  if (returned)
    return go_down(now);
  while (!recent_.empty() && recent_.front() <= now - window.count())
    recent_.pop_front();
  recent_.push_back(now);
  if (recent_.size() >= most) {
    last_rest_ = Milliseconds::zero();
    return go_down(now);
  }
  const auto before = recent_.size() - 1;
  return {false, before == 0 ? Milliseconds::zero()
                             : first_pause * (1 << (before - 1))};
}

FailureRecord::Verdict FailureRecord::go_down(Timestamp now) {
  recent_.clear();
  last_rest_ = last_rest_ == Milliseconds::zero()
                   ? rest
                   : std::min(last_rest_ * 2, longest_rest);
  returns_ = now + last_rest_.count();
  return {true, last_rest_};
}

} // namespace parlour::actors
