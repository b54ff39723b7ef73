#include "adapters/standins/log_reports.hpp"
#include "tests/adapters/standins/stand_in_fixture.hpp"

namespace parlour::adapters {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class LogReportsTest : public StandInTest {
protected:
  void SetUp() override {
    folder.write("weather.tsv", "place\twhen\ttext\tdegrees\n"
                                "Changi\t2026-11-22\tSunny.\t32\n"
                                "Changi\t*\tShowers.\t29\n");
    folder.write("traffic.tsv", "road\ttext\nPIE\tSlow.\nAYE\tClear.\n");
  }
};

TEST_F(LogReportsTest, ReadsOutTheWeather) {
  ASSERT_TRUE(start(log_weather_factory(), {{"reports", "weather.tsv"}}));
  EXPECT_THAT(tell("Ask", {"changi", "2026-11-22"}),
              ElementsAre("Report(Sunny., {place: Changi, when: 2026-11-22, "
                          "text: Sunny., degrees: 32})"));
  EXPECT_THAT(tell("Ask", {"Changi", "2026-11-23"}).front(),
              HasSubstr("Showers."));
  EXPECT_THAT(record("weather"), HasSubstr("\tAsk\tchangi,2026-11-22\n"));
}

TEST_F(LogReportsTest, ReadsNothingOutsideOfTheApplication) {
  for (const auto* name : {"../weather.tsv", "/etc/passwd"}) {
    const auto started = start(log_weather_factory(), {{"reports", name}});
    ASSERT_FALSE(started) << name;
    EXPECT_EQ(started.error().kind, ErrorKind::settings);
    EXPECT_THAT(started.error().message, HasSubstr("option 'reports'"));
  }
}

TEST_F(LogReportsTest, SaysWhatThereIs) {
  ASSERT_TRUE(start(log_traffic_factory(), {{"reports", "traffic.tsv"}}));
  EXPECT_THAT(tell("Ask", {"Orchard Road"}),
              ElementsAre("Failed(There is no report for 'Orchard Road'; "
                          "there are reports for PIE, AYE.)"));
}

TEST_F(LogReportsTest, ReportsTheFirstWhereNothingIsAsked) {
  ASSERT_TRUE(start(log_traffic_factory(), {{"reports", "traffic.tsv"}}));
  EXPECT_THAT(tell("Ask"),
              ElementsAre("Report(Slow., {road: PIE, text: Slow.})"));
}

TEST_F(LogReportsTest, NeedsItsFile) {
  auto started = start(log_traffic_factory(), {});
  ASSERT_FALSE(started);
  EXPECT_EQ(started.error().kind, ErrorKind::settings);
  started = start(log_traffic_factory(), {{"reports", "missing.tsv"}});
  ASSERT_FALSE(started);
  EXPECT_EQ(started.error().kind, ErrorKind::file);
  EXPECT_FALSE(start(log_traffic_factory(), {{"reports", "weather.tsv"}}));
}

} // namespace
} // namespace parlour::adapters
