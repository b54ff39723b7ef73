#include "runtime/base/metrics.hpp"

#include <algorithm>
#include <numeric>

namespace parlour {

namespace {

constexpr std::array<Nanoseconds, Histogram::bounds_count> make_bounds() {
  std::array<Nanoseconds, Histogram::bounds_count> all{};
  std::size_t i = 0;
  Nanoseconds tenth = 1'000; // of a power of ten: bounds are whole numbers
  while (i < all.size()) {
    for (const int times : {10, 15, 20, 30, 50, 70})
      all[i++] = times * tenth;
    tenth *= 10;
  }
  return all;
}

constexpr double seconds(Nanoseconds time) {
  return static_cast<double>(time) / 1e9;
}

} // namespace

const std::array<Nanoseconds, Histogram::bounds_count> Histogram::bounds =
    make_bounds();

void Histogram::observe(Nanoseconds took) {
  const auto bucket = std::lower_bound(bounds.begin(), bounds.end(), took);
  buckets_[static_cast<std::size_t>(bucket - bounds.begin())].fetch_add(
      1, std::memory_order_relaxed);
  sum_.fetch_add(took, std::memory_order_relaxed);
}

Histogram::Counts Histogram::counts() const {
  Counts counts;
  for (std::size_t i = 0; i < buckets_.size(); ++i)
    counts.buckets[i] = buckets_[i].load(std::memory_order_relaxed);
  counts.sum = sum_.load(std::memory_order_relaxed);
  return counts;
}

std::uint64_t Histogram::Counts::count() const {
  return std::accumulate(buckets.begin(), buckets.end(), std::uint64_t{0});
}

std::optional<double> Histogram::Counts::quantile(double part) const {
  const auto wanted = part * static_cast<double>(count());
  double below = 0;
  for (std::size_t i = 0; i < buckets.size(); ++i) {
    const auto here = static_cast<double>(buckets[i]);
    if (here > 0 && below + here >= wanted) {
      const auto from = i == 0 ? 0 : seconds(bounds[i - 1]);
      const auto to = i == bounds_count ? from : seconds(bounds[i]);
      return from + (to - from) * (wanted - below) / here;
    }
    below += here;
  }
  return std::nullopt;
}

Histogram::Counts Histogram::Counts::since(const Counts& earlier) const {
  auto since = *this;
  for (std::size_t i = 0; i < buckets.size(); ++i)
    since.buckets[i] -= std::min(earlier.buckets[i], buckets[i]);
  since.sum -= earlier.sum;
  return since;
}

Metric metric(std::string name, MetricKind kind, std::string sentence,
              double value) {
  Metric made{std::move(name), kind, std::move(sentence)};
  made.samples.push_back({{}, value});
  return made;
}

Metric metric(std::string name, std::string sentence, const Histogram& time) {
  Metric made{std::move(name), MetricKind::histogram, std::move(sentence)};
  made.samples.push_back({{}, 0, time.counts()});
  return made;
}

const Metric* find(const Metrics& all, const std::string& name) {
  const auto found = std::ranges::find(all, name, &Metric::name);
  return found == all.end() ? nullptr : &*found;
}

} // namespace parlour
