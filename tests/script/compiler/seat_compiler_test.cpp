#include <gmock/gmock.h>

#include "script/compiler/compiler.hpp"
#include "script/compiler/seat_compiler.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::script {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Compiled compile(const std::string& seat) {
  test::TemporaryFolder folder;
  folder.write("settings.xml", "<settings>\n" + seat + "</settings>");
  folder.write("own.xml",
               "<dialogue><routes><open source='Bell' command='Rings'/>"
               "</routes></dialogue>");
  return compile_application(folder.path(), {});
}

TEST(SeatCompiler, reads_the_events_that_open_a_conversation) {
  const auto compiled =
      compile("<seat name='desk' opens='VAD.speechStarted, Kiosk.Touch'/>"
              "<seat name='hall'/>");
  ASSERT_TRUE(compiled.program);
  const auto& openings = compiled.program->openings;
  ASSERT_EQ(openings.size(), 3u);
  EXPECT_EQ(openings[0].seat, ""); // of the script
  EXPECT_EQ(openings[1].source, "VAD");
  EXPECT_EQ(openings[1].command, "SpeechStarted");
  EXPECT_EQ(openings[1].condition, no_code);
  EXPECT_EQ(openings[1].seat, "desk");
  EXPECT_EQ(openings[1].position.line, 2u);
  EXPECT_EQ(openings[2].source, "Kiosk");
  EXPECT_EQ(openings[2].command, "Touch");
}

TEST(SeatCompiler, tells_of_what_is_no_event) {
  for (const auto* wrong : {"Touch", ".Touch", "Kiosk."}) {
    const auto compiled =
        compile("<seat name='desk' opens='" + std::string(wrong) + "'/>");
    EXPECT_FALSE(compiled.program);
    std::vector<std::string> lines;
    for (const auto& finding : compiled.findings.all())
      if (finding.severity == Severity::error)
        lines.push_back(to_string(finding));
    EXPECT_THAT(lines,
                ElementsAre(HasSubstr(
                    ":2:26: error: '" + std::string(wrong) +
                    "' is no event: expected who fires it and what, such as "
                    "VAD.SpeechStarted; several are separated by commas")));
  }
}

} // namespace
} // namespace parlour::script
