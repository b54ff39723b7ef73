#include <gtest/gtest.h>

#include "actors/components/instance/instance_directory.hpp"

namespace parlour::actors {
namespace {

TEST(InstanceDirectory, NamesThoseThatHaveNotReturned) {
  InstanceDirectory directory;
  auto ear = std::make_shared<CallWatchdog>();
  auto mouth = std::make_shared<CallWatchdog>();
  auto hand = std::make_shared<CallWatchdog>();
  directory.add("Ear", ear);
  directory.add("Mouth", mouth);
  directory.add("Hand", hand);
  EXPECT_EQ(directory.names_in_call(), "");
  InFlight none;
  for (const auto& one : {ear, mouth, hand})
    one->begin(0, none);
  mouth->end(none);
  hand->give_up();
  EXPECT_EQ(directory.names_in_call(), "Ear, Hand");
  ear.reset();
  EXPECT_EQ(directory.names_in_call(), "Hand");
}

TEST(InstanceDirectory, AsksNobodyWhoHasGone) {
  InstanceDirectory directory;
  const auto ear = std::make_shared<CallWatchdog>();
  directory.add("Ear", ear); // without a host
  EXPECT_TRUE(directory.handles().empty());
}

} // namespace
} // namespace parlour::actors
