#include <gtest/gtest.h>

#include "script/support/footprint.hpp"

namespace parlour::script {

TEST(Footprint, GrowsWithWhatAValueHolds) {
  const auto own = footprint(Value(1));
  EXPECT_EQ(footprint(Value(std::string(100, 'x'))), own + 100);
  EXPECT_EQ(footprint(Value(List{Value(1), Value(2)})), 3 * own);
  EXPECT_GT(footprint(Value(Map{{"key", Value(1)}})), 2 * own);
  ResultSet rows;
  rows.columns = {"a"};
  rows.cells = {Value(std::string(100, 'x'))};
  EXPECT_GT(footprint(Value(rows)), 2 * own + 100);
}

} // namespace parlour::script
