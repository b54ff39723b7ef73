// What a load has shown: turns, latencies, what went wrong and where.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "runtime/base/clock.hpp"

namespace parlour::tools {

class LoadFigures {
public:
  using Moment = std::chrono::steady_clock::time_point;
  using Duration = std::chrono::steady_clock::duration;

  void answered(Duration latency) {
    latencies_.push_back(latency);
  }
  void opened(Duration time) {
    openings_.push_back(time);
  }
  void finished() {
    ++conversations_;
  }
  // The same place is told once, with how often.
  void wrong(const std::string& place);
  void failed(const std::string& error);

  std::uint64_t turns() const {
    return latencies_.size();
  }
  std::uint64_t conversations() const {
    return conversations_;
  }
  std::uint64_t wrong_answers() const {
    return wrong_;
  }
  std::uint64_t errors() const {
    return errors_;
  }
  bool all_right() const {
    return wrong_ == 0 && errors_ == 0;
  }

  // Lines for people, over this time.
  std::vector<std::string> lines(Duration time) const;

private:
  std::vector<Duration> latencies_; // of turns, from when they were to be sent
  std::vector<Duration> openings_;  // from connecting to welcome
  std::uint64_t conversations_ = 0;
  std::uint64_t wrong_ = 0;
  std::uint64_t errors_ = 0;
  std::map<std::string, std::uint64_t> places_;
};

// The resident memory of a process of this machine, in bytes; 0: not known.
std::uint64_t memory_of(std::uint64_t process);

} // namespace parlour::tools
