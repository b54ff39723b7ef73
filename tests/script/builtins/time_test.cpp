#include <gtest/gtest.h>

#include "tests/script/rows.hpp"

namespace parlour::script {

namespace {

// It is 2026-11-21 09:00 in the rows' scripts.
TEST(BuiltinsTime, Now) {
  test::expect_rows({
      {"now()", "1795251600"},
      {"type(now())", "integer"},
      {"now() == now()", "true"},
  });
}

TEST(BuiltinsTime, Date) {
  test::expect_rows({
      {"date()", "2026-11-21"},
      {"date('%d.%m.%Y')", "21.11.2026"},
      {"date('%A')", "Saturday"},
      {"date(unknown, 0)", "1970-01-01"},
      {"date('%Y', now() + 86400 * 60)", "2027"},
      {"date('%Y-%m-%d', -1)", "1969-12-31"},
      {"date('')", ""},
      {"date('%Y', 1e15)", "Range: date: the time is out of the calendar"},
      {"date('%Y', 'x')",
       "Type: date: argument 2 must be a number, not a string"},
      {"date([])", "Type: date: argument 1 must be a string, not a list"},
  });
}

TEST(BuiltinsTime, Time) {
  test::expect_rows({
      {"time()", "09:00"},
      {"time('%H:%M:%S', 3661)", "01:01:01"},
      {"time(unknown, 1.9)", "00:00"},
      {"time('%I %p')", "09 AM"},
      {"time({})", "Type: time: argument 1 must be a string, not a map"},
  });
}

} // namespace

} // namespace parlour::script
