#include "tools/parlour/console/in_parallel.hpp"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace parlour::tools {

// Threads take the next one from a shared counter.
void in_parallel(std::size_t count, unsigned threads,
                 const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  const auto take = [&] {
    for (auto i = next++; i < count; i = next++)
      work(i);
  };
  const auto wanted =
      threads ? threads : std::max(1u, std::thread::hardware_concurrency());
  std::vector<std::jthread> others;
  for (unsigned i = 1; i < std::min<std::size_t>(wanted, count); ++i)
    others.emplace_back(take);
  take();
}

} // namespace parlour::tools
