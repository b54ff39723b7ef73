#include "tools/parlour/load/load_figures.hpp"

#include <algorithm>
#include <fstream>

#include <fmt/format.h>
#include <unistd.h>

namespace parlour::tools {

namespace {

using Durations = std::vector<LoadFigures::Duration>;

constexpr std::size_t max_places = 20; // that are told
constexpr std::size_t max_known = 1'000;

double milliseconds(LoadFigures::Duration time) {
  return std::chrono::duration<double, std::milli>(time).count();
}

double at(const Durations& sorted, double part) {
  const auto place =
      static_cast<std::size_t>(part * static_cast<double>(sorted.size()));
  return milliseconds(sorted[std::min(place, sorted.size() - 1)]);
}

std::string distribution(const char* name, Durations all) {
  if (all.empty())
    return fmt::format("{}: none", name);
  std::ranges::sort(all);
  return fmt::format(
      "{}: p50 {:.2f} ms, p95 {:.2f} ms, p99 {:.2f} ms, max {:.2f} ms", name,
      at(all, 0.5), at(all, 0.95), at(all, 0.99), milliseconds(all.back()));
}

} // namespace

void LoadFigures::wrong(const std::string& place) {
  ++wrong_;
  if (places_.size() < max_known || places_.contains(place))
    ++places_[place];
}

void LoadFigures::failed(const std::string& error) {
  ++errors_;
  if (places_.size() < max_known || places_.contains(error))
    ++places_[error];
}

std::vector<std::string> LoadFigures::lines(Duration time) const {
  const auto seconds = std::chrono::duration<double>(time).count();
  std::vector<std::string> lines{
      fmt::format("{} conversations, {} turns in {:.2f} s: {:.0f} turns/s",
                  conversations_, turns(), seconds,
                  static_cast<double>(turns()) / seconds),
      distribution("a turn's answer", latencies_),
      distribution("a session's beginning", openings_),
      fmt::format("{} wrong answers, {} errors", wrong_, errors_)};
  for (const auto& [place, times] : places_) {
    if (lines.size() > 4 + max_places) {
      lines.push_back(fmt::format("… {} more", places_.size() - max_places));
      break;
    }
    lines.push_back(fmt::format("{} times: {}", times, place));
  }
  return lines;
}

std::uint64_t memory_of(std::uint64_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/statm");
  std::uint64_t pages = 0;
  std::uint64_t resident = 0;
  file >> pages >> resident;
  return resident * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

} // namespace parlour::tools
