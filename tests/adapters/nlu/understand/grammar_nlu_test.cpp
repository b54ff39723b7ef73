#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/adapters/nlu/sample.hpp"
#include "tests/support/fake_plugin_host.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::adapters {
namespace {

class GrammarNLU : public testing::Test {
protected:
  GrammarNLU() {
    host_.model =
        std::make_shared<UnderstandingModel>(nlu::test::sample_model());
    host_.columns = nlu::test::sample_column;
    host_.time.set(nlu::test::sample_now());
  }

  Expected<void> start(Options options) {
    return plugin_->start(host_, options);
  }

  const std::string platform_ = parlour::test::source_path("config/platform");
  parlour::test::FakePluginHost host_;
  std::unique_ptr<IPlugin> plugin_ = grammar_nlu_factory().create();
};

TEST_F(GrammarNLU, AnswersWithActs) {
  ASSERT_TRUE(start({{"platform", platform_}}));
  plugin_->receive(parlour::test::message(
      "DoNLU", {"is there a bank and is there a toilet"}));
  ASSERT_EQ(host_.events.size(), 1U);
  EXPECT_EQ(host_.events[0].command, "FrameInfo");
  EXPECT_EQ(host_.events[0].correlation, 7U);
  EXPECT_EQ(host_.events[0].params.size(), 2U);
}

TEST_F(GrammarNLU, SaysThatThereIsNoResult) {
  ASSERT_TRUE(start({{"platform", platform_}}));
  plugin_->receive(parlour::test::message("DoNLU", {"blub"}));
  plugin_->receive(parlour::test::message("DoNLU"));
  EXPECT_EQ(host_.take_events(),
            (std::vector<std::string>{"NoResult(blub)", "NoResult()"}));
}

TEST_F(GrammarNLU, TakesTheTimeOfThePlatform) {
  ASSERT_TRUE(start({{"platform", platform_}}));
  plugin_->receive(parlour::test::message("DoNLU", {"in ten minutes"}));
  ASSERT_EQ(host_.events.size(), 1U);
  const auto& act = host_.events[0].params[0];
  EXPECT_EQ(act["slots"]["Time"]["value"].text(), "09:10");
}

// Engine rule 1.9.
TEST_F(GrammarNLU, UnderstandsTheNewValuesOfAColumn) {
  host_.model = std::make_shared<UnderstandingModel>(UnderstandingModel{
      {{"Visit", false, {{"Host", "query", {}, "db:staff.name", true}}, {}}},
      {}});
  host_.columns = [](const std::string&) {
    return Expected<std::vector<std::string>>({"Jeffery Ho"});
  };
  const auto host_of = [this](const std::string& text) {
    host_.events.clear();
    plugin_->receive(parlour::test::message("DoNLU", {text}));
    return host_.events[0].params[0]["slots"]["Host"]["value"].text();
  };
  ASSERT_TRUE(start({{"platform", platform_}}));
  EXPECT_EQ(host_of("Zelda Quill"), "unknown");
  plugin_->receive(parlour::test::message(
      "SetValues", {"db:staff.name", List{"Jeffery Ho", "Zelda Quill"}}));
  EXPECT_EQ(host_of("Zelda Quill"), "Zelda Quill");
  EXPECT_EQ(host_of("Jeffery Ho"), "Jeffery Ho");
  plugin_->receive(parlour::test::message(
      "SetValues", {"db:staff.name", List{"Zelda Quill"}}));
  EXPECT_EQ(host_of("Jeffery Ho"), "unknown");
  EXPECT_TRUE(host_.logs.empty());
}

TEST_F(GrammarNLU, IgnoresTheValuesOfOtherColumns) {
  ASSERT_TRUE(start({{"platform", platform_}}));
  plugin_->receive(parlour::test::message("SetValues", {"db:a.b", List{"x"}}));
  plugin_->receive(parlour::test::message("SetValues"));
  EXPECT_TRUE(host_.events.empty());
  EXPECT_TRUE(host_.logs.empty());
}

TEST_F(GrammarNLU, DoesNotStartWithWrongSettings) {
  EXPECT_EQ(start({}).error().kind, ErrorKind::settings);
  EXPECT_EQ(start({{"platform", "/nowhere"}}).error().kind, ErrorKind::file);
  for (const auto* outside : {"../acts.jsgf", "/etc/passwd"})
    EXPECT_EQ(
        start({{"platform", platform_}, {"generic", outside}}).error().kind,
        ErrorKind::settings);
  for (const auto* wrong : {"much", "2", "-0.1"})
    EXPECT_EQ(
        start({{"platform", platform_}, {"threshold", wrong}}).error().kind,
        ErrorKind::settings);
}

TEST_F(GrammarNLU, LearnsExamplesOfAFile) {
  const parlour::test::TemporaryFolder folder;
  host_.application = folder.path().string();
  folder.write("more.tsv", "Taxi\tI want to be driven\n");
  ASSERT_TRUE(start({{"platform", platform_}, {"examples", "more.tsv"}}));
  plugin_->receive(parlour::test::message("DoNLU", {"I want to be driven"}));
  ASSERT_EQ(host_.events.size(), 1U);
  EXPECT_EQ(host_.events[0].params[0]["topic"].text(), "Taxi");
}

TEST_F(GrammarNLU, LearnsWordingsOfAFile) {
  const parlour::test::TemporaryFolder folder;
  host_.application = folder.path().string();
  folder.write("heard.tsv", "Taxi Time=noon\tI want to be driven\n");
  ASSERT_TRUE(start({{"platform", platform_}, {"wordings", "heard.tsv"}}));
  plugin_->receive(parlour::test::message("DoNLU", {"I want to be driven"}));
  ASSERT_EQ(host_.events.size(), 1U);
  EXPECT_EQ(host_.events[0].params[0]["topic"].text(), "Taxi");
  folder.write("heard.tsv", "Taxi Tim=noon\tI want to be driven\n");
  EXPECT_THAT(start({{"platform", platform_}, {"wordings", "heard.tsv"}})
                  .error()
                  .message,
              testing::HasSubstr("the topic 'Taxi' has no slot 'Tim'"));
}

// New values make a new engine of what was read at the start, whatever is being
// edited meanwhile.
TEST_F(GrammarNLU, ReadsItsFilesOnce) {
  const parlour::test::TemporaryFolder folder;
  host_.application = folder.path().string();
  folder.write("more.tsv", "Taxi\tI want to be driven\n");
  ASSERT_TRUE(start({{"platform", platform_}, {"examples", "more.tsv"}}));
  folder.write("more.tsv", "Taxy\n");
  plugin_->receive(parlour::test::message(
      "SetValues", {"db:staff.name", List{"Zelda Quill"}}));
  EXPECT_TRUE(host_.logs.empty());
  plugin_->receive(parlour::test::message("DoNLU", {"I want to be driven"}));
  ASSERT_EQ(host_.events.size(), 1U);
  EXPECT_EQ(host_.events[0].params[0]["topic"].text(), "Taxi");
}

TEST_F(GrammarNLU, TellsAllThatIsWrongAtOnce) {
  const parlour::test::TemporaryFolder folder;
  host_.application = folder.path().string();
  folder.write("more.tsv", "Taxy\tI want to be driven\nTaxi\n");
  const auto started = start(
      {{"platform", platform_}, {"examples", "more.tsv"}, {"threshold", "2"}});
  ASSERT_FALSE(started);
  for (const auto* part : {"from 0 to 1",
                           "more.tsv:1:1: there is no topic "
                           "'Taxy', did you mean 'Taxi'?",
                           "more.tsv:2:1: a line is"})
    EXPECT_THAT(started.error().message, testing::HasSubstr(part));
  EXPECT_EQ(start({{"platform", platform_}, {"examples", "../x"}}).error().kind,
            ErrorKind::settings);
}

TEST_F(GrammarNLU, ReportsAColumnThatCannotBeRead) {
  host_.columns = nullptr;
  const auto started = start({{"platform", platform_}});
  ASSERT_FALSE(started);
  EXPECT_NE(started.error().message.find("@db:staff.name"), std::string::npos);
}

} // namespace
} // namespace parlour::adapters
