#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.hpp"
#include "tools/bench/script/script_workload.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;

class ScriptWorkloadTest : public testing::Test {
protected:
  Expected<ScriptWorkload> load(const std::string& content) {
    folder_.write("x.xml", "<dialogue>" + content + "</dialogue>");
    return ScriptWorkload::load(folder_.path() / "x.xml");
  }

  test::TemporaryFolder folder_;
};

TEST_F(ScriptWorkloadTest, gives_what_work_returns) {
  const auto workload = load("<const name=\"operations\" expr=\"2\"/>"
                             "<function name=\"work\"><wait for=\"1m\"/>"
                             "<return expr=\"40 + operations\"/></function>");
  ASSERT_TRUE(workload);
  const auto measured = workload->run();
  ASSERT_TRUE(measured);
  EXPECT_EQ(measured->result, "42");
  EXPECT_GT(measured->nanoseconds, 0);
}

TEST_F(ScriptWorkloadTest, an_error_is_told) {
  const auto workload = load("<function name=\"work\">"
                             "<return expr=\"1 / 0\"/></function>");
  ASSERT_TRUE(workload);
  EXPECT_THAT(workload->run().error().message, HasSubstr("zero"));
}

TEST_F(ScriptWorkloadTest, a_finding_is_told) {
  EXPECT_THAT(
      load("<function name=\"work\"><brake/></function>").error().message,
      HasSubstr("brake"));
  EXPECT_THAT(load("").error().message, HasSubstr("'work'"));
}

TEST_F(ScriptWorkloadTest, larger_activations_hold_more) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer's memory is not malloc's";
#endif
  const auto small = load("<function name=\"work\"><wait for=\"1m\"/>"
                          "</function>")
                         ->suspended_bytes();
  std::string many;
  for (int i = 0; i < 100; ++i)
    many += "<var name=\"v" + std::to_string(i) + "\" expr=\"1\"/>";
  const auto large =
      load("<function name=\"work\">" + many + "<wait for=\"1m\"/></function>")
          ->suspended_bytes();
  EXPECT_GT(*small, 8);
  EXPECT_GT(*large, *small + 700);
}

} // namespace
} // namespace parlour::tools
