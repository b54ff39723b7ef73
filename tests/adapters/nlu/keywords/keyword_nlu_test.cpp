#include <filesystem>
#include <fstream>

#include "adapters/nlu/keywords/keyword_nlu.hpp"
#include "tests/adapters/nlu/keywords/keyword_fixture.hpp"
#include "tests/support/fake_plugin_host.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::adapters {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class KeywordNluTest : public testing::Test {
protected:
  KeywordNluTest() {
    host.application = folder.path().string();
    host.model = std::make_shared<const UnderstandingModel>(nlu::desk_model());
    host.columns = nlu::desk_columns();
  }
  Expected<void> start(const std::string& rules) {
    std::ofstream(folder.path() / "keywords.xml") << rules;
    return plugin->start(host, {{"rules", "keywords.xml"}});
  }
  std::string answer_to(std::string command, std::vector<Value> params) {
    plugin->receive(
        parlour::test::message(std::move(command), std::move(params)));
    const auto event = host.events.back();
    return event.command +
           (event.params.empty() ? "" : ' ' + to_string(event.params.front()));
  }

  parlour::test::TemporaryFolder folder;
  parlour::test::FakePluginHost host;
  std::unique_ptr<IPlugin> plugin = keyword_nlu_factory().create();
};

TEST_F(KeywordNluTest, AnswersAsTheRoleDoes) {
  ASSERT_TRUE(start(nlu::desk_xml));
  EXPECT_THAT(answer_to("DoNLU", {"where is Spot"}), HasSubstr("FrameInfo {"));
  EXPECT_EQ(answer_to("DoNLU", {"the weather"}), "NoResult the weather");
  EXPECT_EQ(answer_to("DoNLU", {}), "NoResult ");
  EXPECT_THAT(answer_to("Sing", {}), HasSubstr("Failed NLU does not know"));
}

// As every plug-in of the role: a list is no text.
TEST_F(KeywordNluTest, UnderstandsTextsOnly) {
  ASSERT_TRUE(start(nlu::desk_xml));
  EXPECT_EQ(answer_to("DoNLU", {Value(List{"where is Spot"})}), "NoResult ");
}

TEST_F(KeywordNluTest, UnderstandsTheNewValuesOfAColumn) {
  ASSERT_TRUE(start(nlu::desk_xml));
  EXPECT_THAT(answer_to("DoNLU", {"where is Zelda"}),
              testing::Not(HasSubstr("value: Zelda")));
  std::filesystem::remove(folder.path() / "keywords.xml");
  plugin->receive(
      parlour::test::message("SetValues", {"db:robot.name", List{"Zelda"}}));
  EXPECT_THAT(host.logs, testing::IsEmpty());
  EXPECT_THAT(answer_to("DoNLU", {"where is Zelda"}),
              HasSubstr("value: Zelda"));
}

TEST_F(KeywordNluTest, SaysWhatIsWrongWithItsRules) {
  const auto wrong = start("<keywords>\n<rule/>\n<a/></keywords>");
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().place.line, 2u);
  EXPECT_THAT(wrong.error().message,
              HasSubstr("keywords.xml:3:1: <a> is not known here"));
}

TEST_F(KeywordNluTest, NeedsItsRulesInTheApplicationsFolder) {
  EXPECT_EQ(plugin->start(host, {{"rules", "none.xml"}}).error().kind,
            ErrorKind::file);
  EXPECT_THAT(plugin->start(host, {{"rules", "../a.xml"}}).error().message,
              HasSubstr("leaves its folder"));
  EXPECT_THAT(plugin->start(host, {}).error().message,
              HasSubstr("option 'rules'"));
}

} // namespace
} // namespace parlour::adapters
