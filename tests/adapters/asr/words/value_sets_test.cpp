#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/asr/words/value_sets.hpp"

namespace parlour::adapters::asr {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

class ValueSetsTest : public testing::Test {
protected:
  ValueSetsTest() {
    model.topics.push_back(
        {"Taxi",
         false,
         {{"Size", "set", {"small", "large"}, "", false, false},
          {"Time", "time", {}, "", false, false},
          {"Seats", "range", {}, "", false, false},
          {"Driver", "query", {}, "db:staff.name", false, false},
          {"Destination", "", {}, "", false, false}},
         {}});
  }

  UnderstandingModel model;
  Symbols symbols;
  Spellings spellings;
};

TEST_F(ValueSetsTest, AreThoseOfSlotsAndColumns) {
  int reads = 0;
  ValueSets sets(
      model,
      [&](const std::string&) {
        ++reads;
        return std::vector<std::string>{"Dr. Ho", "Dr. Ho", "", "Siti"};
      },
      symbols, spellings);
  EXPECT_THAT(sets.values(sets.set_of("Taxi.Size")), SizeIs(2));
  EXPECT_THAT(sets.values(sets.set_of("Taxi.Driver")), SizeIs(2));
  EXPECT_EQ(sets.set_of("db:staff.name"), sets.set_of("Taxi.Driver"));
  EXPECT_EQ(reads, 1);
  EXPECT_EQ(sets.set_of("Taxi.Time"), sets.form("time"));
  EXPECT_EQ(sets.set_of("Taxi.Seats"), sets.form("number"));
  EXPECT_EQ(sets.set_of("words", "Destination"),
            sets.set_of("Taxi.Destination"));
  EXPECT_EQ(spellings.written("ho"), "Ho");
  EXPECT_THAT(sets.errors(), IsEmpty());
}

TEST_F(ValueSetsTest, TellWhatCannotBeRead) {
  ValueSets sets(model, nullptr, symbols, spellings);
  const auto set = sets.set_of("db:staff.name");
  EXPECT_THAT(sets.values(set), IsEmpty());
  EXPECT_THAT(sets.errors(), SizeIs(1));
  EXPECT_TRUE(sets.graphs().contains(set));
}

TEST_F(ValueSetsTest, SpellingsTellNamesFromWords) {
  spellings.note("Please call Siti at Food Chain", true);
  spellings.note("Chinese food", false);
  EXPECT_EQ(spellings.written("siti"), "Siti");
  EXPECT_EQ(spellings.written("food"), "food");
  EXPECT_EQ(spellings.written("please"), "please");
}

} // namespace
} // namespace parlour::adapters::asr
