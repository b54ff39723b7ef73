#include <gtest/gtest.h>

#include "tests/support/temporary_folder.hpp"
#include "tools/bench/script/state_bench.hpp"

namespace parlour::tools {
namespace {

TEST(StateBench, tells_what_a_state_takes) {
  const test::TemporaryFolder folder;
  folder.write("a.xml", "<dialogue><var name='x' expr='[1, 2]'/>"
                        "<function name='main'><wait for='1s'/></function>"
                        "</dialogue>");
  const auto times = state_once(folder.path() / "a.xml");
  ASSERT_TRUE(times) << times.error().message;
  EXPECT_GT(times->bytes, 20u);
  EXPECT_LT(times->bytes, 100u);
  EXPECT_GE(times->save, 0);
}

TEST(StateBench, a_script_with_findings_has_none) {
  const test::TemporaryFolder folder;
  folder.write("a.xml", "<dialogue><nothing/></dialogue>");
  EXPECT_FALSE(state_once(folder.path() / "a.xml"));
}

} // namespace
} // namespace parlour::tools
