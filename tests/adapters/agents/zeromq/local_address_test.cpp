#include <gtest/gtest.h>

#include "adapters/agents/zeromq/local_address.hpp"

namespace parlour::adapters::agents {
namespace {

TEST(LocalAddress, IsOneThatOtherHostsCannotReach) {
  for (const auto* local :
       {"tcp://127.0.0.1:5672", "tcp://127.0.0.2:*", "tcp://[::1]:5672",
        "tcp://localhost:5672", "ipc:///run/parlour", "inproc://taps"})
    EXPECT_TRUE(is_local_address(local)) << local;
  for (const auto* reachable :
       {"tcp://*:5672", "tcp://0.0.0.0:5672", "tcp://[::]:*", "tcp://eth0:5672",
        "tcp://127.example.org:5672", "tcp://localhost.example.org:*",
        "udp://127.0.0.1:5672", ""})
    EXPECT_FALSE(is_local_address(reachable)) << reachable;
}

} // namespace
} // namespace parlour::adapters::agents
