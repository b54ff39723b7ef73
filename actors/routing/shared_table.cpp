#include "actors/routing/shared_table.hpp"

namespace parlour::actors {

namespace {

std::size_t number_of_thread() {
  static std::atomic<std::size_t> last = 0;
  thread_local const auto number = ++last;
  return number;
}

} // namespace

void SharedTable::store(const Pointer& table) {
  for (auto& place : places_) {
    const auto holder = std::make_shared<const Holder>(Holder{table});
    place.table.store(Pointer(holder, holder->table.get()));
  }
}

SharedTable::Pointer SharedTable::load() const {
  return places_[number_of_thread() % places_.size()].table.load();
}

} // namespace parlour::actors
