#include <gtest/gtest.h>

#include "tests/support/temporary_folder.hpp"
#include "tools/bench/script/load_bench.hpp"

namespace parlour::tools {
namespace {

TEST(LoadBench, a_pattern_is_repeated_with_its_number) {
  EXPECT_EQ(repeated_script("<a@/>\n", 20),
            "<dialogue>\n<a0/>\n<a1/>\n</dialogue>\n");
}

TEST(LoadBench, both_are_measured) {
  const test::TemporaryFolder folder;
  folder.write("x.xml", repeated_script("<function name=\"f@\"/>\n", 1000));
  const auto times = load_once(folder.path() / "x.xml");
  ASSERT_TRUE(times);
  EXPECT_GT(times->ours, 0);
  EXPECT_GT(times->parse_and_walk, 0);
}

TEST(LoadBench, findings_are_an_error) {
  const test::TemporaryFolder folder;
  folder.write("x.xml", repeated_script("<brake/>", 20));
  EXPECT_FALSE(load_once(folder.path() / "x.xml"));
}

} // namespace
} // namespace parlour::tools
