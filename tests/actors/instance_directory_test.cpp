#include <gtest/gtest.h>

#include "actors/component.hpp"
#include "actors/instance_directory.hpp"

namespace parlour::actors {
namespace {

std::shared_ptr<Instance> instance(const char* name) {
  auto component = std::make_shared<Component>();
  component->order.name = name;
  auto made = std::make_shared<Instance>();
  made->component = std::move(component);
  return made;
}

TEST(InstanceDirectory, NamesThoseThatHaveNotReturned) {
  InstanceDirectory directory;
  auto ear = instance("Ear");
  auto mouth = instance("Mouth");
  auto hand = instance("Hand");
  for (const auto& one : {ear, mouth, hand})
    directory.add(one);
  EXPECT_EQ(directory.names_in_call(), "");
  Work none;
  for (const auto& one : {ear, mouth, hand})
    one->watch.begin(0, none);
  mouth->watch.end(none);
  hand->watch.give_up();
  EXPECT_EQ(directory.names_in_call(), "Ear, Hand");
  ear.reset();
  EXPECT_EQ(directory.names_in_call(), "Hand");
}

} // namespace
} // namespace parlour::actors
