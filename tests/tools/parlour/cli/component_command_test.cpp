#include "tests/tools/parlour/command_fixture.hpp"

namespace parlour::tools {
namespace {

// Serving a component is tested in process_isolation_test.cpp.
TEST_F(CommandTest, component_is_not_for_people) {
  EXPECT_EQ(call({"component", "LogTaxi"}), exit_code::usage);
  EXPECT_EQ(err_.str(),
            "error: parlour starts this by itself for a component with "
            "host=\"process\"\n");
}

} // namespace
} // namespace parlour::tools
