#include <gtest/gtest.h>

#include "actors/routing/instance_directory.hpp"

namespace parlour::actors {
namespace {

TEST(InstanceDirectory, NamesThoseThatHaveNotReturned) {
  InstanceDirectory directory;
  auto ear = std::make_shared<CallWatch>();
  auto mouth = std::make_shared<CallWatch>();
  auto hand = std::make_shared<CallWatch>();
  directory.add("Ear", ear);
  directory.add("Mouth", mouth);
  directory.add("Hand", hand);
  EXPECT_EQ(directory.names_in_call(), "");
  Work none;
  for (const auto& one : {ear, mouth, hand})
    one->begin(0, none);
  mouth->end(none);
  hand->give_up();
  EXPECT_EQ(directory.names_in_call(), "Ear, Hand");
  ear.reset();
  EXPECT_EQ(directory.names_in_call(), "Hand");
}

} // namespace
} // namespace parlour::actors
