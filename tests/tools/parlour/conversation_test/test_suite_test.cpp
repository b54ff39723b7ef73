#include "tests/support/temporary_folder.hpp"
#include "tests/tools/parlour/application_fixture.hpp"
#include "tools/parlour/conversation_test/test_suite.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;

class TestSuiteTest : public ApplicationTest {
protected:
  TestSuiteTest() {
    places_.working = folder_.path();
  }

  test::TemporaryFolder folder_;
  Places places_;
  Application greeter_ = load("greeter");
};

TEST_F(TestSuiteTest, holds_all_conversations_of_an_application) {
  const auto suite = read_suite(greeter_, {}, places_);
  ASSERT_TRUE(suite);
  ASSERT_EQ(suite->conversations.size(), 1u);
  EXPECT_EQ(suite->conversations[0].name, "all");
  EXPECT_EQ(suite->files[0].filename(), "all.txt");
  EXPECT_TRUE(suite->findings.empty());
}

TEST_F(TestSuiteTest, holds_those_that_are_named) {
  folder_.write("x.txt", "R: Hello.\n");
  const auto suite = read_suite(greeter_, {"x.txt", "all", "all.txt"}, places_);
  ASSERT_TRUE(suite);
  ASSERT_EQ(suite->conversations.size(), 3u);
  EXPECT_EQ(suite->conversations[0].file, "x.txt");
  EXPECT_EQ(suite->conversations[2].name, "all");
}

TEST_F(TestSuiteTest, tells_what_is_wrong_with_them) {
  folder_.write("x.txt", "say hello\nexpect state Nowhere\n");
  const auto suite = read_suite(greeter_, {"x.txt"}, places_);
  ASSERT_TRUE(suite);
  EXPECT_EQ(suite->findings.size(), 2u);
  EXPECT_THAT(read_suite(greeter_, {"none"}, places_).error().message,
              HasSubstr("there is no conversation 'none'"));
}

} // namespace
} // namespace parlour::tools
