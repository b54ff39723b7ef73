// Exchanging a component (paper III.D): two changed lines choose another one
// for a role.
#include "tests/tools/parlour/changed_application.hpp"
#include "tools/parlour/application/node_options.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

using ExchangeTest = ChangedApplication;

constexpr const char* keywords = R"(<component name="KeywordNLU">
    <option name="rules" value="keywords.xml"/></component>
  <component name="SQLiteDatabase")";

TEST_F(ExchangeTest, KeywordsUnderstandInsteadOfGrammars) {
  copy("lab");
  change("settings.xml", "GrammarNLU", "KeywordNLU");
  change("settings.xml", R"(<component name="SQLiteDatabase")", keywords);
  const auto application = load_changed();
  EXPECT_THAT(findings(application), IsEmpty());
  EXPECT_EQ(hold(application, "borrow.txt"), "");
  EXPECT_EQ(hold(application, "interrupted.txt"), "");
  EXPECT_EQ(hold(application, "where.txt"), "");
}

TEST_F(ExchangeTest, RulesOfKeywordsAreChecked) {
  copy("lab");
  change("settings.xml", "GrammarNLU", "KeywordNLU");
  change("settings.xml", R"(<component name="SQLiteDatabase")", keywords);
  change("keywords.xml", R"(<slot name="Day"/>)", R"(<slot name="Dya"/>)");
  EXPECT_THAT(findings(load_changed()),
              HasSubstr("keywords.xml:9:1: error: the topic Borrow has no slot "
                        "'Dya'; there are Robot, Day"));
}

// One line gives a voice to an application that has none.
TEST_F(ExchangeTest, AVoiceWritesWhatIsSaidToAFile) {
  copy("lab");
  change("settings.xml", "<Plugin>SQLiteDatabase",
         "<Plugin>TextFileTTS</Plugin><Plugin>SQLiteDatabase");
  const auto application = load_changed();
  EXPECT_THAT(findings(application), IsEmpty());
  test::TemporaryFolder data;
  auto node = actors::Node::start(node_options(
      application, rehearsed(application.composition),
      {data.path().string(), parse_timestamp("2026-11-21 09:00").value(), 1}));
  ASSERT_TRUE(node);
  const auto seat = (*node)->open_seat(
      {[](const SessionId&, const dialogue::Output&) {}, {}});
  (*node)->enter(seat, {"where is Spot?"});
  ASSERT_TRUE((*node)->run_until_quiet());
  (*node)->advance(Milliseconds(5000));
  EXPECT_EQ(read(data.path() / "speech.txt"),
            "09:00:00\tWelcome to the robot lab. What would you like?\n"
            "09:00:02\tSpot is in room 12.\n");
}

} // namespace
} // namespace parlour::tools
