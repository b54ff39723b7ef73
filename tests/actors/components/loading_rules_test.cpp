#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "actors/components/loading_rules.hpp"
#include "tests/actors/plugin_shelf.hpp"

namespace parlour::actors {
namespace {

class LoadingRulesTest : public testing::Test {
protected:
  LoadingRulesTest() {
    settings.plugins = shelf;
    shelf->put(taxi("City"));
  }

  std::shared_ptr<PluginShelf> shelf = std::make_shared<PluginShelf>();
  ComponentSettings settings;
  Deployments deployments;
  LoadingRules rules{settings, deployments};
};

TEST_F(LoadingRulesTest, AComponentHasItsPluginsNameUnlessItHasAnother) {
  EXPECT_EQ(rules.order_for("City", "")->name, "City");
  EXPECT_EQ(rules.order_for("City", "Cab")->name, "Cab");
  EXPECT_FALSE(rules.order_for("Country", ""));
}

TEST_F(LoadingRulesTest, WhatTheSettingsSaidOfItStillCounts) {
  auto order = taxi("City");
  order.options = {{"fare", "5"}};
  order.policy.scope.instances = 0; // for <load> alone
  rules.remember(order);
  const auto loaded = rules.order_for("City", "");
  EXPECT_EQ(loaded->options.at("fare"), "5");
  EXPECT_EQ(loaded->policy.scope.instances, 1u);
  EXPECT_TRUE(rules.order_for("City", "Cab")->options.empty());
}

TEST_F(LoadingRulesTest, OneIsLoadedOnceAtATime) {
  const auto order = taxi("City");
  EXPECT_TRUE(rules.check(order));
  deployments.coming["City"] = std::make_shared<Deployment>();
  EXPECT_EQ(rules.check(order).error().message,
            "City: is being loaded already");
}

TEST_F(LoadingRulesTest, AnOptionThatIsMissingIsNamed) {
  auto order = taxi("City");
  OptionDescription fare;
  fare.name = "fare";
  fare.required = true;
  fare.sentence = "what a ride costs";
  order.factory.description.options = {fare};
  EXPECT_EQ(rules.check(order).error().message,
            "City: the option 'fare' is missing: what a ride costs");
}

TEST_F(LoadingRulesTest, OneThatIsNotThereIsGuessed) {
  deployments.serving["City"] = std::make_shared<Deployment>();
  EXPECT_THAT(rules.nobody_called("Citty").message,
              testing::AllOf(HasSubstr("there is no component 'Citty'"),
                             HasSubstr("City'?")));
}

} // namespace
} // namespace parlour::actors
