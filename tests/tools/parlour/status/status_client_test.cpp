#include <filesystem>

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include "tests/support/temporary_folder.hpp"
#include "tools/parlour/status/status_client.hpp"
#include "tools/parlour/status/status_server.hpp"

namespace parlour::tools {
namespace {

TEST(StatusClient, FindsNobodyInAnEmptyFolderOrNone) {
  test::TemporaryFolder folder;
  EXPECT_TRUE(ask_status(folder.path()).empty());
  EXPECT_TRUE(ask_status(folder.path() / "nowhere").empty());
}

// As a process leaves it that was killed.
TEST(StatusClient, RemovesASocketThatNobodyListensAt) {
  test::TemporaryFolder folder;
  const auto path = folder.path() / "7.sock";
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  path.string().copy(address.sun_path, sizeof address.sun_path - 1);
  const int left = socket(AF_UNIX, SOCK_STREAM, 0);
  ASSERT_EQ(bind(left, reinterpret_cast<sockaddr*>(&address), sizeof address),
            0);
  close(left);
  EXPECT_TRUE(ask_status(folder.path()).empty());
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(StatusClient, AnAnswerThatIsNoneIsAnError) {
  test::TemporaryFolder folder;
  const auto runtime = folder.path() / "parlour";
  const auto server =
      StatusServer::open(runtime, [](const auto&) { return "hello"; });
  ASSERT_TRUE(server);
  const auto told = ask_status(runtime);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_FALSE(told.front());
}

} // namespace
} // namespace parlour::tools
