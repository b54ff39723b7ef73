#include <filesystem>

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.hpp"
#include "tools/parlour/status/status_client.hpp"
#include "tools/parlour/status/status_server.hpp"

namespace parlour::tools {
namespace {

// As long as a node with many sessions tells.
TEST(StatusServer, TellsWhoeverAsks) {
  test::TemporaryFolder folder;
  const auto runtime = folder.path() / "parlour";
  StatusReport report{"desk", "/apps/desk", 42, 0, {}};
  report.actors.resize(2'000);
  const auto server =
      StatusServer::open(runtime, [&] { return to_json(report); });
  ASSERT_TRUE(server) << to_string(server.error());
  for (int i = 0; i < 3; ++i) {
    const auto told = ask_status(runtime);
    ASSERT_EQ(told.size(), 1u);
    ASSERT_TRUE(told.front());
    EXPECT_EQ(told.front()->application, "desk");
    EXPECT_EQ(told.front()->actors.size(), 2'000u);
  }
}

TEST(StatusServer, TakesItsSocketAway) {
  test::TemporaryFolder folder;
  const auto runtime = folder.path() / "parlour";
  {
    const auto server = StatusServer::open(runtime, [] { return ""; });
    ASSERT_TRUE(server);
    EXPECT_FALSE(std::filesystem::is_empty(runtime));
  }
  EXPECT_TRUE(std::filesystem::is_empty(runtime));
}

TEST(StatusServer, SaysWhyItCannotBeReached) {
  test::TemporaryFolder folder;
  folder.write("file", "");
  const auto server =
      StatusServer::open(folder.path() / "file", [] { return ""; });
  EXPECT_FALSE(server);
}

} // namespace
} // namespace parlour::tools
