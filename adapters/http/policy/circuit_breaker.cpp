#include "adapters/http/policy/circuit_breaker.hpp"

#include <algorithm>

namespace parlour::adapters::http {

std::optional<CircuitBreaker::Pass> CircuitBreaker::admit(Moment now) {
  switch (state(now)) {
  case State::closed:
    return Pass{};
  case State::open:
    return std::nullopt;
  case State::half_open:
    break;
  }
  if (is_tried_)
    return std::nullopt;
  is_tried_ = true;
  return Pass{true};
}

// A request from before may still succeed; only the trial closes it, since that
// one is newer.
void CircuitBreaker::succeeded(Pass pass) {
  if (!is_closed_ && !pass.is_trial)
    return;
  is_closed_ = true;
  is_tried_ = false;
  failures_ = 0;
}

// Failures of requests from before count for nothing while it is open.
void CircuitBreaker::failed(Pass pass, Moment now, const std::string& reason) {
  if (!is_closed_ && !pass.is_trial)
    return;
  ++failures_;
  last_ = reason;
  if (pass.is_trial || (terms_.failures != 0 && failures_ >= terms_.failures))
    open(now);
}

void CircuitBreaker::withdrawn(Pass pass) {
  if (pass.is_trial)
    is_tried_ = false;
}

void CircuitBreaker::open(Moment now) {
  is_closed_ = false;
  is_tried_ = false;
  opened_until_ = now + terms_.pause;
}

CircuitBreaker::State CircuitBreaker::state(Moment now) const {
  if (is_closed_)
    return State::closed;
  return now < opened_until_ ? State::open : State::half_open;
}

std::string CircuitBreaker::refusal(Moment now) const {
  auto text = "has failed " + std::to_string(failures_) +
              " times in a row (it " + last_ + "), so it is ";
  if (state(now) == State::half_open)
    return text + "tried with one request first";
  const auto left = std::chrono::ceil<std::chrono::seconds>(
      std::max(opened_until_ - now, Moment::duration::zero()));
  return text + "not asked for " + std::to_string(left.count()) + " s more";
}

} // namespace parlour::adapters::http
