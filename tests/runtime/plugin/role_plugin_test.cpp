#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/plugin/role_plugin.hpp"
#include "tests/support/fake_plugin_host.hpp"

namespace parlour {
namespace {

using test::FakePluginHost;
using test::message;
using testing::ElementsAre;

class Driver : public RolePlugin {
public:
  explicit Driver(std::string_view role) : RolePlugin(role) {
    on("Book", &Driver::on_book);
    on("Speed", &Driver::on_speed);
    on("Park", &Driver::on_park);
  }

private:
  void on_book(const std::string& from, const std::string& to,
               const Value& time, const std::string& name) {
    fire_event("Booked", {from + to + time.text() + name, 3});
  }
  void on_speed(std::int64_t speed, std::optional<bool> at_once) {
    fire_event("Faster", {speed, at_once.value_or(false)});
  }
  void on_park() {
    fire_event("Parked");
  }
};

class RolePluginTest : public testing::Test {
protected:
  void SetUp() override {
    ASSERT_TRUE(plugin.start(host, {}));
  }
  std::vector<std::string> tell(std::string command,
                                std::vector<Value> params = {}) {
    plugin.receive(message(std::move(command), std::move(params)));
    return host.take_events();
  }

  FakePluginHost host;
  Driver plugin{"Taxi"};
};

TEST_F(RolePluginTest, CallsWithTypedParameters) {
  EXPECT_THAT(tell("Book", {"a", "b", 9, "c"}), ElementsAre("Booked(ab9c, 3)"));
  EXPECT_THAT(tell("Park"), ElementsAre("Parked()"));
  EXPECT_THAT(tell("Park", {"what is too much is let pass"}),
              ElementsAre("Parked()"));
}

TEST_F(RolePluginTest, LetsOptionalOnesBeMissing) {
  EXPECT_THAT(tell("Speed", {50}), ElementsAre("Faster(50, false)"));
  EXPECT_THAT(tell("Speed", {50, Value()}), ElementsAre("Faster(50, false)"));
  EXPECT_THAT(tell("Speed", {50, true}), ElementsAre("Faster(50, true)"));
}

TEST_F(RolePluginTest, RefusesWhatDoesNotFitInTheRolesWords) {
  EXPECT_THAT(tell("Book", {"a"}),
              ElementsAre("Refused(Book takes a text as its parameter 2, "
                          "'to', which is missing)"));
  EXPECT_THAT(tell("Book", {"a", List{}, 9, "c"}),
              ElementsAre("Refused(Book takes a text as its parameter 2, "
                          "'to', not list)"));
  EXPECT_THAT(tell("Speed", {"fast"}),
              ElementsAre("Refused(Speed takes something else as its "
                          "parameter 1, not 'fast')"));
}

TEST_F(RolePluginTest, RefusesCommandsThatItDoesNotKnow) {
  EXPECT_THAT(tell("Fly"),
              ElementsAre("Refused(Taxi does not know the command 'Fly')"));
}

TEST_F(RolePluginTest, AnswersInTheSessionOfTheMessage) {
  plugin.receive(message("Fly", {}, "s9", 42));
  ASSERT_EQ(host.events.size(), 1u);
  EXPECT_EQ(host.events[0].session, "s9");
  EXPECT_EQ(host.events[0].correlation, 42u);
}

TEST(RolePlugin, SaysNoAsItsRoleDoes) {
  const std::pair<const char*, const char*> cases[] = {
      {"Robot", "Failed(Robot does not know the command 'Fly')"},
      {"Database", "Error(Refused, Database does not know the command 'Fly')"},
      {"TTS", "Failed(TTS does not know the command 'Fly')"}};
  for (const auto& [role, said] : cases) {
    FakePluginHost host;
    Driver plugin(role);
    ASSERT_TRUE(plugin.start(host, {}));
    plugin.receive(message("Fly"));
    EXPECT_THAT(host.take_events(), ElementsAre(said));
  }
}

} // namespace
} // namespace parlour
