#include "tests/tools/parlour/application_fixture.hpp"
#include "tools/parlour/speech/application_host.hpp"

namespace parlour::tools {
namespace {

using testing::Contains;

TEST(ApplicationHostTest, KnowsTheApplication) {
  const auto config = test::source_path("config");
  const auto application =
      load_application(config + "/apps/receptionist", config + "/platform");
  ASSERT_TRUE(application.program);
  const ApplicationHost host(application);
  EXPECT_EQ(host.application_folder(), application.folder.string());
  EXPECT_EQ(host.understanding(), application.program->understanding);
  const auto names = host.column("db:rr_staff.staff_name");
  ASSERT_TRUE(names) << names.error().message;
  EXPECT_THAT(*names, Contains("Jeffery Ho"));
  EXPECT_FALSE(host.column("db:rr_staff.shoe_size"));
}

} // namespace
} // namespace parlour::tools
