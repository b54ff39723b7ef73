#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/standins/report_table.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::adapters {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class ReportTableTest : public testing::Test {
protected:
  Expected<ReportTable> read(const std::string& text) {
    folder.write("reports.tsv", text);
    return ReportTable::read(folder.path() / "reports.tsv", {"place", "when"});
  }

  test::TemporaryFolder folder;
};

TEST_F(ReportTableTest, FindsTheFirstThatMatches) {
  auto table =
      read("# a comment\r\nplace\twhen\ttext\r\n\r\nChangi\ttoday\tA\r\n"
           "Changi\t*\tB\r\n*\t*\tC\r\n");
  ASSERT_TRUE(table);
  EXPECT_EQ(table->find({"CHANGI", "today"})->text, "A");
  EXPECT_EQ(table->find({"Changi", "tomorrow"})->text, "B");
  EXPECT_EQ(table->find({"Bedok", "today"})->text, "C");
  EXPECT_EQ(table->find({"", ""})->text, "A");
  EXPECT_THAT(table->subjects(), ElementsAre("Changi"));
}

TEST_F(ReportTableTest, FindsNothingWhereNothingMatches) {
  auto table = read("place\twhen\ttext\nChangi\t*\tB\n");
  ASSERT_TRUE(table);
  EXPECT_FALSE(table->find({"Bedok", ""}));
}

TEST_F(ReportTableTest, PlacesItsErrors) {
  auto table = read("place\twhen\ttext\n\nChangi\tno text\n");
  ASSERT_FALSE(table);
  EXPECT_EQ(table.error().place.line, 3u);
  EXPECT_THAT(table.error().message, HasSubstr("3 columns, this line 2"));

  table = read("when\tplace\ttext\n");
  ASSERT_FALSE(table);
  EXPECT_EQ(table.error().place.line, 1u);
  EXPECT_THAT(table.error().message, HasSubstr("'place', 'when', 'text'"));

  EXPECT_FALSE(read("place\twhen\tdegrees\nA\tB\tC\n"));
  EXPECT_FALSE(read("place\twhen\ttext\n"));
  EXPECT_FALSE(read(""));
}

TEST_F(ReportTableTest, DoesNotReadAFolder) {
  EXPECT_FALSE(ReportTable::read(folder.path(), {"place"}));
}

} // namespace
} // namespace parlour::adapters
