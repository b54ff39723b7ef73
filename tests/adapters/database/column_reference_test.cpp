#include <gtest/gtest.h>

#include "adapters/database/column_reference.hpp"

namespace parlour::adapters {
namespace {

TEST(ColumnReference, HasTwoPlainNames) {
  auto reference = parse_column("db:rr_staff.staff_name");
  ASSERT_TRUE(reference);
  EXPECT_EQ(reference->table, "rr_staff");
  EXPECT_EQ(reference->column, "staff_name");
  EXPECT_TRUE(parse_column("_a1.B2"));
  for (auto text : {"", "db:", "db:a", "a.", ".b", "a.b.c", "1a.b", "a.b c",
                    "a.b\"", "db:db:a.b", "a.b;--", "é.b"}) {
    auto wrong = parse_column(text);
    ASSERT_FALSE(wrong) << text;
    EXPECT_EQ(wrong.error().kind, ErrorKind::settings);
  }
}

TEST(ColumnReference, IsReadByAQuery) {
  EXPECT_EQ(select_values_of({"staff", "name"}),
            "select distinct \"name\" from \"staff\" where \"name\" is not "
            "null order by 1");
}

} // namespace
} // namespace parlour::adapters
