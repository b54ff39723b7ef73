#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/base/result_rows.hpp"

namespace parlour {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(ResultRows, AreMaps) {
  const ResultSet result{{"id", "name"}, {1, "Ann", 2, Value()}};
  EXPECT_THAT(rows_as_maps(result),
              ElementsAre(Value(Map{{"id", 1}, {"name", "Ann"}}),
                          Value(Map{{"id", 2}, {"name", Value()}})));
}

TEST(ResultRows, LoseNoColumn) {
  const ResultSet result{{"name", "name", "NAME", "name_2", "name"},
                         {"a", "b", "c", "d", "e"}};
  EXPECT_THAT(rows_as_maps(result), ElementsAre(Value(Map{{"name", "a"},
                                                          {"name_3", "b"},
                                                          {"NAME", "c"},
                                                          {"name_2", "d"},
                                                          {"name_4", "e"}})));
}

TEST(ResultRows, MayBeNone) {
  EXPECT_THAT(rows_as_maps({}), IsEmpty());
  EXPECT_THAT(rows_as_maps({{"id"}, {}}), IsEmpty());
}

} // namespace
} // namespace parlour
