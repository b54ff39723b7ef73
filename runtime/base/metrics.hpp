// What a running program counts: counters, gauges and histograms that any
// thread changes without a lock and without memory, and how they are told to
// who asks. Names and units follow Prometheus: "parlour_turns_total",
// "parlour_turn_seconds". What counts owns its numbers; nothing is global.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace parlour {

// Only rises.
class Counter {
public:
  void add(std::uint64_t more = 1) {
    value_.fetch_add(more, std::memory_order_relaxed);
  }
  std::uint64_t value() const {
    return value_.load(std::memory_order_relaxed);
  }

private:
  std::atomic<std::uint64_t> value_ = 0;
};

using Nanoseconds = std::int64_t;

// How long things took, in buckets of fixed bounds: 1, 1.5, 2, 3, 5 and 7 times
// each power of ten, from 10 µs to 70 s.
class Histogram {
public:
  static constexpr std::size_t bounds_count = 42;
  // What is not longer belongs to the bucket; the last bucket has no bound.
  static const std::array<Nanoseconds, bounds_count> bounds;

  void observe(Nanoseconds took);

  struct Counts {
    std::array<std::uint64_t, bounds_count + 1> buckets = {};
    Nanoseconds sum = 0;

    std::uint64_t count() const;
    // Such as 0.99: below this time, in seconds, that part of all is; nothing
    // where there is none. Between two bounds it is estimated.
    std::optional<double> quantile(double part) const;
    // What has come since.
    Counts since(const Counts& earlier) const;
  };
  // While others observe, the sum and the buckets may differ by these.
  Counts counts() const;

private:
  std::array<std::atomic<std::uint64_t>, bounds_count + 1> buckets_ = {};
  std::atomic<Nanoseconds> sum_ = 0;
};

// -- as it is told ------------------------------------------------------------

enum class MetricKind : std::uint8_t { counter, gauge, histogram };

struct MetricSample {
  using Labels = std::vector<std::pair<std::string, std::string>>;
  Labels labels = {};
  double value = 0;            // of a counter or a gauge
  Histogram::Counts time = {}; // of a histogram
};

// All samples of one name.
struct Metric {
  std::string name; // "parlour_turns_total"
  MetricKind kind = MetricKind::counter;
  std::string sentence;
  std::vector<MetricSample> samples = {};
};
using Metrics = std::vector<Metric>;

Metric metric(std::string name, MetricKind kind, std::string sentence,
              double value);
Metric metric(std::string name, std::string sentence, const Histogram& time);
// Null where there is none of that name.
const Metric* find(const Metrics& all, const std::string& name);

} // namespace parlour
