#include <future>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include <asio/buffer.hpp>
#include <asio/read.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/loop/acceptor_over.hpp"
#include "adapters/loop/loop.hpp"
#include "adapters/loop/standalone_asio.hpp"
#include "tests/support/no_descriptors.hpp"
#include "tests/support/tcp_client.hpp"

namespace parlour::adapters {
namespace {

using test::Client;
using testing::AllOf;
using testing::Ge;
using testing::Le;
using Acceptor = AcceptorOver<StandaloneAsio>;

const Acceptor::Endpoint anywhere(asio::ip::address_v4::loopback(), 0);

// Each accepted connection hears a line and is closed.
class AcceptorOverTest : public testing::Test {
protected:
  ~AcceptorOverTest() override {
    loop->post([this] { acceptor.close(); });
    loop->stop();
  }
  // Once it returns, no descriptor is taken for a moment: to accept, the system
  // takes one, and gives it back if nobody is there.
  void accept(Acceptor::Calls calls) {
    ASSERT_TRUE(acceptor.open(anywhere));
    do_on_the_loop([&] { acceptor.accept(std::move(calls)); });
  }
  static void greet(StandaloneAsio::Socket socket) {
    socket.send(asio::buffer("hello", 5));
  }
  // What is done by then is done.
  void do_on_the_loop(const std::function<void()>& action) {
    std::promise<void> done;
    loop->post([&] {
      action();
      done.set_value();
    });
    done.get_future().wait();
  }
  std::string heard() {
    return Client(acceptor.address()).receive_all();
  }

  std::vector<std::string> thrown;
  std::unique_ptr<Loop> loop = Loop::start([this](const std::string& what) {
                                 thrown.push_back(what);
                               }).value();
  Acceptor acceptor{loop->context()};
};

TEST_F(AcceptorOverTest, AcceptsOneAfterTheOther) {
  accept({greet});
  EXPECT_THAT(acceptor.address(), testing::StartsWith("127.0.0.1:"));
  for (int i = 0; i < 3; ++i)
    EXPECT_EQ(heard(), "hello");
}

TEST_F(AcceptorOverTest, WhoFindsNoRoomWaits) {
  bool has_room = true;
  accept({[&](StandaloneAsio::Socket socket) {
            has_room = false;
            greet(std::move(socket));
          },
          [&] { return has_room; }});
  EXPECT_EQ(heard(), "hello");
  Client second(acceptor.address());
  auto hears =
      std::async(std::launch::async, [&] { return second.receive_all(); });
  do_on_the_loop([&] { EXPECT_FALSE(has_room); });
  loop->post([&] {
    has_room = true;
    acceptor.go_on();
    acceptor.go_on(); // changes nothing
  });
  EXPECT_EQ(hears.get(), "hello");
}

TEST_F(AcceptorOverTest, GoesOnAfterAnException) {
  bool is_first = true;
  accept({[&](StandaloneAsio::Socket socket) {
    if (std::exchange(is_first, false))
      throw std::runtime_error("too much");
    greet(std::move(socket));
  }});
  EXPECT_EQ(heard(), "");
  EXPECT_EQ(heard(), "hello");
  do_on_the_loop(
      [&] { EXPECT_THAT(thrown, testing::ElementsAre("too much")); });
}

// Accepting fails at once while no file may be opened: it is not tried in each
// turn of the loop, but again when there are files.
TEST_F(AcceptorOverTest, PausesAfterItHasFailed) {
  std::promise<std::string> first;
  int failures = 0;
  accept({greet, {}, [&](const std::string& why) {
            if (++failures == 1)
              first.set_value(why);
          }});
  asio::io_context context;
  asio::ip::tcp::socket socket(context, asio::ip::tcp::v4());
  auto none =
      std::make_optional<test::NoDescriptors>(socket.native_handle() + 1);
  const auto port = acceptor.address().substr(acceptor.address().find(':') + 1);
  socket.connect(
      {anywhere.address(), static_cast<std::uint16_t>(std::stoi(port))});
  EXPECT_EQ(first.get_future().get(), "Too many open files");
  for (int i = 0; i < 500; ++i)
    do_on_the_loop([] {});
  do_on_the_loop([&] { EXPECT_THAT(failures, AllOf(Ge(1), Le(50))); });
  none.reset();
  std::string held;
  asio::error_code error;
  asio::read(socket, asio::dynamic_buffer(held), error);
  EXPECT_EQ(held, "hello");
}

TEST_F(AcceptorOverTest, AcceptsNobodyOnceItIsClosed) {
  accept({greet});
  do_on_the_loop([&] {
    acceptor.close();
    acceptor.close();
    acceptor.go_on();
  });
  EXPECT_FALSE(Client(acceptor.address()).is_connected());
}

TEST_F(AcceptorOverTest, SaysWhyItCannotListen) {
  accept({greet});
  Acceptor second(loop->context());
  const auto port = acceptor.address().substr(acceptor.address().find(':') + 1);
  const auto opened = second.open(
      {anywhere.address(), static_cast<std::uint16_t>(std::stoi(port))});
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().kind, ErrorKind::network);
  EXPECT_EQ(opened.error().message, "Address already in use");
}

TEST_F(AcceptorOverTest, WritesAddressesOfIPv6InBrackets) {
  Acceptor six(loop->context());
  if (!six.open({asio::ip::address_v6::loopback(), 0}))
    GTEST_SKIP() << "no IPv6 here";
  EXPECT_THAT(six.address(), testing::StartsWith("[::1]:"));
}

} // namespace
} // namespace parlour::adapters
