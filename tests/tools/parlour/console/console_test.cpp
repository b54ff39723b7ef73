#include <cerrno>
#include <sstream>

#include <gtest/gtest.h>

#include "tools/parlour/console/console.hpp"
#include "tools/parlour/console/exit_code.hpp"

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

TEST(Console, tells_of_what_cannot_be_written_unless_nobody_reads) {
  std::ostringstream out;
  std::ostringstream err;
  Console console{out, err};
  EXPECT_EQ(status_of_printing(console, exit_code::success),
            exit_code::success);
  EXPECT_EQ(err.str(), "");
  out.setstate(std::ios::badbit);
  console.trouble = [] { return ENOSPC; };
  EXPECT_EQ(status_of_printing(console, exit_code::success), exit_code::wrong);
  EXPECT_EQ(status_of_printing(console, exit_code::usage), exit_code::usage);
  const std::string line = "error: what is printed cannot be written: No space "
                           "left on device\n";
  EXPECT_EQ(err.str(), line + line);
  console.trouble = [] { return EPIPE; };
  EXPECT_EQ(status_of_printing(console, exit_code::success),
            exit_code::nobody_reads);
  EXPECT_EQ(err.str(), line + line);
}

TEST(Console, colours_only_where_told) {
  std::ostringstream out;
  std::ostringstream err;
  EXPECT_EQ(coloured(Console{out, err}, red, "x"), "x");
  EXPECT_EQ(coloured(Console{out, err, true}, red, "x"), "\033[31mx\033[0m");
}

} // namespace
} // namespace parlour::tools
