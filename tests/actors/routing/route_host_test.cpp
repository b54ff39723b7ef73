#include <gtest/gtest.h>

#include "actors/routing/route_host.hpp"
#include "script/vm/interpreter.hpp"

namespace parlour::actors {
namespace {

class Idle : public script::Activation {
public:
  Idle() : Activation({}) {}
};

class RouteHostTest : public testing::Test {
protected:
  Message message = [] {
    Message result;
    result.session = "s1";
    return result;
  }();
  RouteHost host{message, 1234};
  Idle activation;
};

TEST_F(RouteHostTest, KnowsItsMessageAndTheTime) {
  EXPECT_EQ(host.system(activation, script::SystemVariable::session),
            Value("s1"));
  EXPECT_TRUE(
      host.system(activation, script::SystemVariable::state).is_unknown());
  EXPECT_EQ(host.now(), 1234);
}

TEST_F(RouteHostTest, KnowsNothingElse) {
  host.set_slot(0, 0, 5);
  EXPECT_TRUE(host.slot(0, 0).is_unknown());
  EXPECT_FALSE(host.online("Database"));
  EXPECT_EQ(host.random(), 0);
}

TEST_F(RouteHostTest, RefusesEffects) {
  const script::Effect effect(script::EffectKind::post);
  const auto outcome = host.perform(activation, effect);
  ASSERT_TRUE(std::holds_alternative<Error>(outcome));
  EXPECT_EQ(std::get<Error>(outcome).kind, ErrorKind::refused);
}

} // namespace
} // namespace parlour::actors
