#include <future>
#include <optional>

#include <gmock/gmock.h>

#include "adapters/agents/zeromq/inflow.hpp"
#include "adapters/loop/loop.hpp"
#include "tests/support/start_loop.hpp"

namespace parlour::adapters::agents {
namespace {

using namespace std::chrono_literals;

// Two sockets: what is sent to one is drained from the other on a loop, one
// message at a time, so that rounds and turns are gone through.
class InflowTest : public testing::Test {
protected:
  InflowTest() {
    pull.bind("inproc://here");
    push.connect("inproc://here");
    loop->post([this] {
      inflow.emplace(*loop, pull, [this] { drain(); });
      inflow->go_on();
    });
  }
  ~InflowTest() override {
    loop->post([this] { inflow.reset(); });
    loop->stop();
  }
  void drain() {
    zmq::message_t message;
    if (!pull.recv(message, zmq::recv_flags::dontwait))
      return;
    ++drained;
    if (drained == stops_at)
      inflow->stop();
    if (drained == wanted)
      all.set_value();
  }
  void send(int count) {
    for (int i = 0; i < count; ++i)
      push.send(zmq::str_buffer("x"), zmq::send_flags::none);
  }
  bool all_came() {
    return all.get_future().wait_for(10s) == std::future_status::ready;
  }

  zmq::context_t context;
  zmq::socket_t pull{context, zmq::socket_type::pull};
  zmq::socket_t push{context, zmq::socket_type::push};
  std::unique_ptr<Loop> loop = test::start_loop();
  std::optional<Inflow> inflow;
  int wanted = 0;
  int stops_at = 0;
  int drained = 0;
  std::promise<void> all;
};

TEST_F(InflowTest, HasEverythingDrained) {
  wanted = 500;
  send(500);
  EXPECT_TRUE(all_came());
}

TEST_F(InflowTest, EndsWithinADrain) {
  wanted = stops_at = 3;
  send(100);
  EXPECT_TRUE(all_came());
  loop->stop();
  EXPECT_EQ(drained, 3);
}

} // namespace
} // namespace parlour::adapters::agents
