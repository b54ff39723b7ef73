#include "tests/tools/parlour/application_fixture.hpp"
#include "tools/parlour/application/live_application.hpp"
#include "tools/parlour/application/node_options.hpp"

namespace parlour::tools {
namespace {

using actors::ReloadMode;
using testing::ElementsAre;
using testing::HasSubstr;

// An application whose file changes while a node runs it.
class LiveApplicationTest : public ApplicationTest {
protected:
  static std::string says(const std::string& words) {
    return "<handler name='H'><messages><component><ASR><RecognitionResult>"
           "<speak param='" +
           words +
           "'/></RecognitionResult></ASR></component></messages>"
           "</handler>";
  }
  static actors::NodeOptions options(const Application& application) {
    return node_options(
        application, application.composition,
        {.data_folder = {}, .virtual_start = 1'795'251'600'000, .seed = 1});
  }
  std::variant<Application, int> open(const Console& console) {
    auto application = load("", now_);
    if (!application.has_errors())
      return application;
    console.err << findings(application);
    return 1;
  }

  LiveApplicationTest() {
    node_ = std::move(*actors::Node::start(options(first_)));
    actors::SeatCallbacks calls;
    calls.on_output = [this](const auto&, const dialogue::Output& output) {
      said_.push_back(output.text);
    };
    seat_ = node_->open_seat(std::move(calls));
  }
  std::vector<std::string> said_by_now() {
    node_->enter(seat_, {"hello"});
    node_->run_until_quiet();
    return std::exchange(said_, {});
  }

  std::string now_ = says("One.");
  Application first_ = load("", now_);
  LiveApplication live_{
      first_, [this](const Console& console) { return open(console); },
      options};
  std::vector<std::string> said_;
  std::unique_ptr<actors::Node> node_;
  actors::SeatId seat_;
};

TEST_F(LiveApplicationTest, GoesOverToTheFilesAndBack) {
  EXPECT_THAT(said_by_now(), ElementsAre("One."));
  now_ = says("Two.");
  ASSERT_TRUE(live_.reload(*node_, ReloadMode::keep));
  EXPECT_THAT(said_by_now(), ElementsAre("Two."));
  ASSERT_TRUE(live_.undo(*node_, ReloadMode::keep));
  EXPECT_THAT(said_by_now(), ElementsAre("One."));
  ASSERT_TRUE(live_.undo(*node_, ReloadMode::keep));
  EXPECT_THAT(said_by_now(), ElementsAre("Two."));
}

TEST_F(LiveApplicationTest, StaysWhereFilesAreWrong) {
  now_ = "<speek/>";
  const auto outcome = live_.reload(*node_, ReloadMode::keep);
  ASSERT_FALSE(outcome);
  EXPECT_THAT(outcome.error().message, HasSubstr("<speek>"));
  EXPECT_THAT(said_by_now(), ElementsAre("One."));
  EXPECT_FALSE(live_.undo(*node_, ReloadMode::keep));
}

} // namespace
} // namespace parlour::tools
