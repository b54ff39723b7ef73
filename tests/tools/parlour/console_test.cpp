#include <sstream>

#include <gtest/gtest.h>

#include "tools/parlour/console.hpp"

namespace parlour::tools {
namespace {

TEST(Console, writes_errors_and_warnings_as_lines) {
  std::ostringstream out;
  std::ostringstream err;
  const Console console{out, err};
  say_error(console, "no such thing");
  say_warning(console, "rather odd");
  EXPECT_EQ(err.str(), "error: no such thing\nwarning: rather odd\n");
  EXPECT_EQ(out.str(), "");
}

TEST(Console, colours_only_where_told) {
  std::ostringstream out;
  std::ostringstream err;
  EXPECT_EQ(coloured(Console{out, err}, red, "x"), "x");
  EXPECT_EQ(coloured(Console{out, err, true}, red, "x"), "\033[31mx\033[0m");
}

} // namespace
} // namespace parlour::tools
