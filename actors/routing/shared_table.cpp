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
  for (auto& copy : copies_) {
    const auto holder = std::make_shared<const Holder>(Holder{table});
    copy.table.store(Pointer(holder, holder->table.get()));
  }
}

SharedTable::Pointer SharedTable::load() const {
  return copies_[number_of_thread() % copies_.size()].table.load();
}

} // namespace parlour::actors
