#include <gtest/gtest.h>

#include "script/support/estimated_size.hpp"

namespace parlour::script {

TEST(Footprint, GrowsWithWhatAValueHolds) {
  const auto own = estimated_size(Value(1));
  EXPECT_EQ(estimated_size(Value(std::string(100, 'x'))), own + 100);
  EXPECT_EQ(estimated_size(Value(List{Value(1), Value(2)})), 3 * own);
  EXPECT_GT(estimated_size(Value(Map{{"key", Value(1)}})), 2 * own);
  ResultSet rows;
  rows.columns = {"a"};
  rows.cells = {Value(std::string(100, 'x'))};
  EXPECT_GT(estimated_size(Value(rows)), 2 * own + 100);
}

} // namespace parlour::script
