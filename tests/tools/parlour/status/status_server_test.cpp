#include <ctime>
#include <filesystem>

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include "tests/support/no_descriptors.hpp"
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
      StatusServer::open(runtime, [&](const auto&) { return to_json(report); });
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
    const auto server =
        StatusServer::open(runtime, [](const auto&) { return ""; });
    ASSERT_TRUE(server);
    EXPECT_FALSE(std::filesystem::is_empty(runtime));
  }
  EXPECT_TRUE(std::filesystem::is_empty(runtime));
}

// The lowest that is free.
int next_descriptor() {
  const int next = dup(STDIN_FILENO);
  close(next);
  return next;
}

double seconds_of(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) +
         static_cast<double>(time.tv_nsec) / 1e9;
}

// What all other threads compute while this one computes for so long.
double busy_meanwhile(double seconds) {
  const auto own = seconds_of(CLOCK_THREAD_CPUTIME_ID);
  const auto all = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
  double passed = 0;
  while (passed < seconds)
    passed = seconds_of(CLOCK_THREAD_CPUTIME_ID) - own;
  return seconds_of(CLOCK_PROCESS_CPUTIME_ID) - all - passed;
}

TEST(StatusServer, RestsWhileItCannotAccept) {
  test::TemporaryFolder folder;
  const auto runtime = folder.path() / "parlour";
  const auto server =
      StatusServer::open(runtime, [](const auto&) { return "here"; });
  ASSERT_TRUE(server);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::filesystem::directory_iterator(runtime)->path().string().copy(
      address.sun_path, sizeof address.sun_path - 1);
  const int client = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  {
    const test::NoDescriptors none(next_descriptor());
    ASSERT_EQ(
        connect(client, reinterpret_cast<sockaddr*>(&address), sizeof address),
        0);
    EXPECT_LT(busy_meanwhile(0.1), 0.03);
  }
  char text[8] = {};
  EXPECT_EQ(recv(client, text, sizeof text, 0), 4);
  close(client);
}

TEST(StatusServer, SaysThatThereAreNoDescriptors) {
  test::TemporaryFolder folder;
  const auto runtime = folder.path() / "parlour";
  ASSERT_TRUE(StatusServer::open(runtime, [](const auto&) { return ""; }));
  const test::NoDescriptors but_one(next_descriptor() + 1);
  EXPECT_FALSE(StatusServer::open(runtime, [](const auto&) { return ""; }));
}

TEST(StatusServer, SaysWhyItCannotBeReached) {
  test::TemporaryFolder folder;
  folder.write("file", "");
  const auto server = StatusServer::open(folder.path() / "file",
                                         [](const auto&) { return ""; });
  EXPECT_FALSE(server);
}

} // namespace
} // namespace parlour::tools
