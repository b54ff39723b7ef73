#include <regex>
#include <set>

#include "adapters/standins/log_taxi.hpp"
#include "tests/adapters/standins/stand_in_fixture.hpp"

namespace parlour::adapters {
namespace {

using testing::ElementsAre;

class LogTaxiTest : public StandInTest {
protected:
  std::vector<std::string> book(int times) {
    std::vector<std::string> answers;
    for (int i = 0; i < times; ++i)
      answers.push_back(
          tell("Book", {"here", "Changi Airport", "14:00", "David"}).front());
    return answers;
  }
};

TEST_F(LogTaxiTest, BooksWithPlateAndMinutes) {
  ASSERT_TRUE(start(log_taxi_factory(), {}));
  const std::regex form("Booked\\(SH[ABCDX] [1-9][0-9]{0,3} [A-Z], [0-9]+\\)");
  for (const auto& answer : book(20))
    EXPECT_TRUE(std::regex_match(answer, form)) << answer;
}

TEST_F(LogTaxiTest, SendsTheSameTaxisForTheSameSeed) {
  ASSERT_TRUE(start(log_taxi_factory(), {{"seed", "5"}}));
  const auto first = book(3);
  ASSERT_TRUE(start(log_taxi_factory(), {{"seed", "5"}}));
  EXPECT_EQ(book(3), first);
  ASSERT_TRUE(start(log_taxi_factory(), {{"seed", "6"}}));
  EXPECT_NE(book(3), first);
}

TEST_F(LogTaxiTest, SendsDifferentTaxis) {
  ASSERT_TRUE(start(log_taxi_factory(), {}));
  const auto answers = book(10);
  EXPECT_EQ(std::set<std::string>(answers.begin(), answers.end()).size(), 10u);
}

TEST_F(LogTaxiTest, RefusesAsTold) {
  ASSERT_TRUE(start(log_taxi_factory(), {{"answer", "refused"}}));
  EXPECT_THAT(book(1), ElementsAre("Refused(No taxi is free.)"));
}

TEST_F(LogTaxiTest, NeedsBothEnds) {
  ASSERT_TRUE(start(log_taxi_factory(), {}));
  EXPECT_THAT(
      tell("Book", {"here", Value()}),
      ElementsAre("Refused(A taxi needs to know from where and to where.)"));
}

TEST_F(LogTaxiTest, RefusesWrongOptions) {
  EXPECT_FALSE(start(log_taxi_factory(), {{"answer", "maybe"}}));
  EXPECT_FALSE(start(log_taxi_factory(), {{"seed", "green"}}));
}

TEST(Plate, HasItsCheckLetter) {
  EXPECT_EQ(singapore_check_letter("SBA", 1234), 'G');
  EXPECT_EQ(singapore_check_letter("SBS", 9889), 'U');
  const auto plate = singapore_taxi_plate(3);
  const auto digits = std::stoull(plate.substr(4));
  EXPECT_EQ(plate.back(), singapore_check_letter(plate.substr(0, 3), digits));
}

} // namespace
} // namespace parlour::adapters
