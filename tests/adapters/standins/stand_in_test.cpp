#include "adapters/standins/log_reports.hpp"
#include "adapters/standins/log_sms.hpp"
#include "adapters/standins/log_taxi.hpp"
#include "adapters/standins/log_telephone.hpp"
#include "adapters/standins/stand_in.hpp"
#include "tests/adapters/standins/stand_in_fixture.hpp"

namespace parlour::adapters {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST_F(StandInTest, RecordsEachCommandAtOnce) {
  ASSERT_TRUE(start(log_sms_factory(), {}));
  tell("Send", {"91234567", "Taxi \"SHA 1\", now"});
  EXPECT_EQ(
      record("sms"),
      "2026-11-21T09:00:00\tSend\t91234567,\"Taxi \"\"SHA 1\"\", now\"\n");
  tell("Send", {"91234567", "a\tb\nc\r", Value(), 2});
  EXPECT_THAT(record("sms"),
              HasSubstr("\n2026-11-21T09:00:00\tSend\t91234567,a\\tb\\nc\\r,,"
                        "2\n"));
}

TEST_F(StandInTest, RecordsAndRefusesUnknownCommands) {
  ASSERT_TRUE(start(log_sms_factory(), {}));
  EXPECT_THAT(tell("Burn", {"1"}),
              ElementsAre("Failed(There is no command 'Burn' here.)"));
  EXPECT_EQ(record("sms"), "2026-11-21T09:00:00\tBurn\t1\n");
}

TEST_F(StandInTest, AppendsToTheRecordOfEarlierRuns) {
  folder.write("data/records/mine.log", "before\n");
  ASSERT_TRUE(start(log_sms_factory(), {{"record", "mine"}}));
  tell("Send", {"999", "Help"});
  EXPECT_EQ(record("mine"), "before\n2026-11-21T09:00:00\tSend\t999,Help\n");
}

TEST_F(StandInTest, DoesNotStartWithoutItsRecord) {
  folder.write("data", "a file where the folder should be");
  auto started = start(log_sms_factory(), {});
  ASSERT_FALSE(started);
  EXPECT_EQ(started.error().kind, ErrorKind::file);
  EXPECT_THAT(started.error().place.file, HasSubstr("records/sms.log"));
}

TEST_F(StandInTest, KeepsItsRecordInTheFolder) {
  for (auto name : {"../sms", "a/b", "", ".."}) {
    auto started = start(log_sms_factory(), {{"record", name}});
    ASSERT_FALSE(started) << name;
    EXPECT_EQ(started.error().kind, ErrorKind::settings);
  }
}

TEST(StandIns, SayThatTheyAreStandIns) {
  for (const auto& factory :
       {log_telephone_factory(), log_taxi_factory(), log_sms_factory(),
        log_weather_factory(), log_traffic_factory()}) {
    EXPECT_THAT(factory.description.sentence, HasSubstr("stand-in"));
    EXPECT_EQ(factory.description.roles.size(), 1u);
    EXPECT_TRUE(factory.create());
  }
}

TEST(PhoneNumber, IsDigitsWithTheUsualMarks) {
  for (auto text : {"64781001", "+65 6478 1001", "995", "6478-1001"})
    EXPECT_TRUE(is_phone_number(text)) << text;
  for (auto text :
       {"", "12", "Jeffery", "6478x1001", "64+781001", "+", "1234567890123456"})
    EXPECT_FALSE(is_phone_number(text)) << text;
}

} // namespace
} // namespace parlour::adapters
