#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>

#include "adapters/network/resolver.hpp"
#include "adapters/network/tcp_connection.hpp"
#include "tests/adapters/network/listener.hpp"
#include "tests/adapters/network/told.hpp"

namespace parlour::adapters {
namespace {

using namespace std::chrono_literals;
using test::Listener;
using test::Told;
using testing::ElementsAre;

class TcpConnectionTest : public testing::Test {
protected:
  std::vector<Endpoint> endpoints(const std::string& address) {
    return *resolve_now(*parse_address(address));
  }
  // One turn of whoever polls; waits for what it is interested in.
  void poll_once() {
    pollfd polled{connection.descriptor(), connection.interest(), 0};
    poll(&polled, 1, -1);
    connection.act(polled.revents);
  }

  TcpConnection::Moment start{};
  Told told;
  TcpConnection connection{SocketOrder{"there:1", true, 3s}, told.teller(),
                           start};
};

TEST_F(TcpConnectionTest, TriesOneAddressAfterTheOther) {
  Listener other;
  auto all = endpoints(other.address());
  std::string closed;
  {
    Listener nobody;
    closed = nobody.address();
  }
  all.insert(all.begin(), endpoints(closed)[0]);
  connection.connect(all);
  while (told.now().empty())
    poll_once();
  EXPECT_THAT(told.now(), ElementsAre("opened"));
}

TEST_F(TcpConnectionTest, IsGivenUpWhenItIsLate) {
  EXPECT_EQ(connection.deadline(), start + 3s);
  connection.be_late();
  EXPECT_THAT(told.now(),
              ElementsAre("failed: no connection to there:1 within 3000ms"));
  EXPECT_TRUE(connection.over());
}

TEST_F(TcpConnectionTest, NothingIsToldOnceItIsClosed) {
  Listener other;
  connection.connect(endpoints(other.address()));
  connection.close(start);
  EXPECT_TRUE(connection.over());
  EXPECT_THAT(told.now(), testing::IsEmpty());
  EXPECT_EQ(connection.descriptor(), -1);
}

TEST_F(TcpConnectionTest, WithoutAnAddressThereIsNone) {
  connection.connect({});
  EXPECT_THAT(
      told.now(),
      ElementsAre("failed: no connection to there:1: it has no address"));
}

} // namespace
} // namespace parlour::adapters
