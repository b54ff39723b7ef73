#include "actors/support/shared_by_threads.hpp"

namespace parlour::actors {

std::size_t number_of_thread() {
  static std::atomic<std::size_t> last = 0;
  thread_local const auto number = ++last;
  return number;
}

} // namespace parlour::actors
