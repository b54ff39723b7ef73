#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "actors/components/deployment.hpp"

namespace parlour::actors {
namespace {

using testing::ElementsAre;

DeploymentPointer deployment(const char* name, std::size_t rank) {
  auto made = std::make_shared<Deployment>();
  made->order.name = name;
  made->rank = rank;
  return made;
}

TEST(Deployments, AreFoundByNameOnceTheyServe) {
  Deployments all;
  const auto ear = deployment("Ear", 1);
  all.coming["Ear"] = ear;
  EXPECT_EQ(all.find("Ear"), nullptr);
  EXPECT_TRUE(all.is_coming(ear));
  all.coming.clear();
  all.serving["Ear"] = ear;
  EXPECT_EQ(all.find("Ear"), ear);
  EXPECT_TRUE(all.is_serving(ear));
  EXPECT_FALSE(all.is_coming(ear));
}

// Another of the same name is not the same.
TEST(Deployments, OneThatIsReplacedServesNoMore) {
  Deployments all;
  const auto old_ear = deployment("Ear", 1);
  const auto new_ear = deployment("Ear", 1);
  all.serving["Ear"] = new_ear;
  EXPECT_FALSE(all.is_serving(old_ear));
  EXPECT_TRUE(all.is_serving(new_ear));
}

TEST(Deployments, AreListedInTheOrderOfPreference) {
  Deployments all;
  const auto ear = deployment("Ear", 2);
  const auto mouth = deployment("Mouth", 1);
  const auto hand = deployment("Hand", 3);
  all.serving = {{"Ear", ear}, {"Mouth", mouth}};
  all.coming = {{"Hand", hand}};
  EXPECT_THAT(all.by_rank(), ElementsAre(mouth, ear));
  EXPECT_THAT(all.all(), ElementsAre(ear, mouth, hand));
}

TEST(Deployment, HasAServiceForEachScope) {
  Deployment one;
  one.services = {{"a", std::make_shared<Service>()},
                  {"b", std::make_shared<Service>()}};
  EXPECT_THAT(one.all(),
              ElementsAre(one.services.at("a"), one.services.at("b")));
}

} // namespace
} // namespace parlour::actors
