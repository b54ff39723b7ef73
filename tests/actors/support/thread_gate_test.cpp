#include <thread>

#include <gtest/gtest.h>

#include "actors/support/thread_gate.hpp"

namespace parlour::actors {
namespace {

void from_another_thread(ThreadGate& gate, int& calls) {
  std::thread([&] {
    const bool waits = gate.keeps_out();
    const auto before = calls;
    gate.enter([&] { ++calls; });
    EXPECT_EQ(waits, calls == before);
  }).join();
}

TEST(ThreadGate, StandsOpen) {
  ThreadGate gate(ThreadGate::Kind::open);
  int calls = 0;
  from_another_thread(gate, calls);
  EXPECT_EQ(calls, 1);
  EXPECT_FALSE(gate.drain());
}

TEST(ThreadGate, KeepsOtherThreadsWaiting) {
  ThreadGate gate(ThreadGate::Kind::one_thread);
  int calls = 0;
  from_another_thread(gate, calls);
  EXPECT_EQ(calls, 0);
  EXPECT_FALSE(gate.keeps_out());
  gate.enter([&] { ++calls; });
  EXPECT_EQ(calls, 1);
  EXPECT_TRUE(gate.drain());
  EXPECT_EQ(calls, 2);
  EXPECT_FALSE(gate.drain());
}

} // namespace
} // namespace parlour::actors
