#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/parlour/application/seat_check.hpp"

namespace parlour::tools {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// Notes what is done with it.
class Device : public IPlugin {
public:
  Device(std::vector<std::string>& log, std::string trouble)
      : log_(log), trouble_(std::move(trouble)) {}
  void stop() override {
    log_.push_back("stop");
  }

protected:
  Expected<void> on_start(const Options& options) override {
    log_.push_back("start " + options.at("device") + " in " +
                   host().application_folder() + " and " +
                   host().data_folder());
    if (trouble_.empty())
      return {};
    if (trouble_ == "throw")
      throw std::runtime_error("no driver");
    return fail(ErrorKind::offline, trouble_);
  }
  void on_message(const Message&) override {}

private:
  std::vector<std::string>& log_;
  const std::string trouble_;
};

class SeatCheckTest : public testing::Test {
protected:
  ChosenComponent& add(const std::string& role, const std::string& trouble = "",
                       Scope::Kind scope = Scope::Kind::seat) {
    PluginFactory factory{{"Some" + role, {role}, "is tried"}, [=, this] {
                            return std::make_unique<Device>(log, trouble);
                          }};
    ChosenComponent component{
        "My" + role, std::move(factory), {{"device", "hw:7"}}, {}};
    component.policy.scope.kind = scope;
    composition.components.push_back(std::move(component));
    return composition.components.back();
  }
  std::vector<std::string> errors() {
    std::vector<std::string> all;
    for (const auto& error : seat_errors(composition, "/app", "/data"))
      all.push_back(error.message);
    return all;
  }

  Composition composition;
  std::vector<std::string> log;
};

TEST_F(SeatCheckTest, StartsAndStopsWhatIsAtASeat) {
  add("Microphone");
  EXPECT_THAT(errors(), IsEmpty());
  EXPECT_THAT(log, ElementsAre("start hw:7 in /app and /data", "stop"));
}

TEST_F(SeatCheckTest, TellsOfEachThatCannotStart) {
  add("Microphone", "there is no such device");
  add("PushToTalk");
  add("Speaker", "another program uses it");
  EXPECT_THAT(errors(), ElementsAre("MyMicrophone: there is no such device",
                                    "MySpeaker: another program uses it"));
}

TEST_F(SeatCheckTest, TellsOfOneThatThrows) {
  add("Microphone", "throw");
  EXPECT_THAT(errors(), ElementsAre("MyMicrophone: it throws 'no driver'"));
}

// The node starts these itself, and says what is wrong with them.
TEST_F(SeatCheckTest, LeavesTheOthersToTheNode) {
  add("Microphone", "no", Scope::Kind::usual);
  add("Robot", "no");
  EXPECT_THAT(errors(), IsEmpty());
  EXPECT_THAT(log, IsEmpty());
}

TEST_F(SeatCheckTest, KnowsTheKeyOfTheTerminal) {
  auto& key = add("PushToTalk");
  EXPECT_FALSE(key_of_terminal(composition)); // it is another plug-in
  key.factory.description.name = "KeyPushToTalk";
  EXPECT_FALSE(key_of_terminal(composition)); // it has a device
  key.options.clear();
  EXPECT_EQ(key_of_terminal(composition), &key);
  key.policy.scope.instances = 0; // until it is loaded
  EXPECT_FALSE(key_of_terminal(composition));
}

} // namespace
} // namespace parlour::tools
