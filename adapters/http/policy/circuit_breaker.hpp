// CircuitBreaker decides whether a service is asked at all. One that has failed
// several times in a row is left alone for a while, so that nobody waits for it
// in vain; then one request tries whether it works again:
//
//  closed     requests pass                `failures` in a row: open
//  open       requests are refused         the pause is over: half open
//  half open  one request passes           it succeeds: closed
//                                          it fails: open
//
// It has no clock, no thread and no network.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "runtime/base/clock.hpp"

namespace parlour::adapters::http {

// HttpClient has one for each server.
class CircuitBreaker {
public:
  using Moment = std::chrono::steady_clock::time_point;

  struct Terms {
    // After how many failures in a row it opens; 0: never.
    unsigned failures = 5;
    Milliseconds pause{30'000};
  };
  enum class State : std::uint8_t { closed, open, half_open };

  // One request that may pass. Its end is told once.
  struct Pass {
    bool is_trial = false; // the one of "half open"
  };

  explicit CircuitBreaker(Terms terms) : terms_(terms) {}

  // Nothing: the request is refused.
  std::optional<Pass> admit(Moment now);
  void succeeded(Pass pass);
  // `reason` is the end of a sentence: "answered 503".
  void failed(Pass pass, Moment now, const std::string& reason);
  // It ended without saying anything about the service.
  void withdrawn(Pass pass);

  State state(Moment now) const;
  // Why requests are refused now, as the end of a sentence that begins with the
  // service: "has failed 5 times in a row …".
  std::string refusal(Moment now) const;

private:
  void open(Moment now);

  Terms terms_;
  unsigned failures_ = 0; // in a row
  bool is_closed_ = true;
  bool is_tried_ = false; // the trial of "half open" is under way
  Moment opened_until_{};
  std::string last_;
};

} // namespace parlour::adapters::http
