#include <gtest/gtest.h>
#include <poll.h>

#include "adapters/database/mariadb/connection/mariadb_calls.hpp"
#include "adapters/database/mariadb/connection/task.hpp"

namespace parlour::adapters {
namespace {

constexpr int wants_to_read = 1; // MYSQL_WAIT_READ

// A function as the library has them: it is done when its handle says so.
struct Server {
  int answer = 0; // 0: none yet
  int told = 0;   // the flags that the call was continued with
};

int ask_start(int* result, Server* server, int) {
  *result = server->answer;
  return server->answer != 0 ? 0 : wants_to_read;
}

int ask_cont(int* result, Server* server, int ready) {
  server->told = ready;
  *result = server->answer;
  return server->answer != 0 ? 0 : wants_to_read;
}

Task<int> ask(MariaDBCalls& calls, Server& server) {
  co_return co_await calls.make<int>(ask_start, ask_cont, &server, 7);
}

TEST(MariaDBCallsTest, AreDoneAtOnceOrWait) {
  MariaDBCalls calls;
  Server server{5};
  auto done = ask(calls, server);
  done.start();
  ASSERT_TRUE(done.done());
  EXPECT_EQ(done.result(), 5);

  server = {};
  auto task = ask(calls, server);
  task.start();
  EXPECT_FALSE(task.done());
  EXPECT_TRUE(calls.is_waiting());
  EXPECT_EQ(calls.interest(), POLLIN);
  calls.go_on(POLLIN);
  EXPECT_FALSE(task.done());
  EXPECT_EQ(server.told, wants_to_read);
  server.answer = 6;
  calls.go_on(POLLHUP);
  ASSERT_TRUE(task.done());
  EXPECT_EQ(task.result(), 6);
  EXPECT_FALSE(calls.is_waiting());
}

TEST(MariaDBCallsTest, HaveADeadlineWhileTheyWait) {
  MariaDBCalls calls;
  calls.give_time(Milliseconds(0));
  EXPECT_TRUE(calls.is_late());
  EXPECT_EQ(calls.deadline(), MariaDBCalls::Moment::max());
  Server server;
  auto task = ask(calls, server);
  task.start();
  EXPECT_LT(calls.deadline(), MariaDBCalls::Moment::max());
  // Nothing is ready.
  server.answer = 1;
  calls.go_on(0);
  EXPECT_NE(server.told & 8, 0); // MYSQL_WAIT_TIMEOUT
  EXPECT_TRUE(task.done());
  calls.give_time(Milliseconds(3'600'000));
  EXPECT_FALSE(calls.is_late());
}

} // namespace
} // namespace parlour::adapters
