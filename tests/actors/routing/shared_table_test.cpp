#include <thread>
#include <vector>

#include "actors/routing/shared_table.hpp"
#include "tests/actors/node_fixture.hpp"

namespace parlour::actors {
namespace {

SharedTable::Pointer some_table() {
  RoutingTable::Parts parts;
  parts.program = compile("");
  return std::make_shared<const RoutingTable>(std::move(parts));
}

TEST(SharedTable, ShowsTheLastOneToEveryThread) {
  SharedTable shared;
  EXPECT_EQ(shared.load(), nullptr);
  shared.store(some_table());
  const auto last = some_table();
  shared.store(last);
  std::vector<std::thread> threads;
  for (int i = 0; i < 40; ++i) // more than there are places
    threads.emplace_back([&] { EXPECT_EQ(shared.load().get(), last.get()); });
  for (auto& thread : threads)
    thread.join();
  shared.store(nullptr);
  EXPECT_EQ(shared.load(), nullptr);
}

TEST(SharedTable, ShowsEachThreadOneAfterTheOtherWhileTheyAreStored) {
  SharedByThreads<int> shared;
  shared.store(std::make_shared<const int>(0));
  constexpr int last = 1000;
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([&] {
      for (int seen = 0; seen < last;) {
        const auto now = *shared.load();
        ASSERT_GE(now, seen);
        seen = now;
      }
    });
  for (int i = 1; i <= last; ++i)
    shared.store(std::make_shared<const int>(i));
  for (auto& thread : threads)
    thread.join();
}

TEST(SharedTable, KeepsOneForWhoUsesItAndNoLonger) {
  SharedTable shared;
  auto table = some_table();
  const std::weak_ptr first = table;
  shared.store(std::exchange(table, some_table()));
  auto used = shared.load();
  shared.store(table);
  EXPECT_FALSE(first.expired());
  used.reset();
  EXPECT_TRUE(first.expired());
}

} // namespace
} // namespace parlour::actors
