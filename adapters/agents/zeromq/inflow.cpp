#include "adapters/agents/zeromq/inflow.hpp"

#include <utility>

#include <poll.h>

namespace parlour::adapters::agents {

namespace {

constexpr int rounds_at_once = 4;

} // namespace

Inflow::Inflow(Loop& loop, zmq::socket_t& socket, std::function<void()> drain)
    : loop_(loop), watch_(loop, [this](short) { run(); }), socket_(socket),
      drain_(std::move(drain)) {}

void Inflow::stop() {
  is_stopped_ = true;
  watch_.stop();
}

// Some rounds at once: to come back later costs more than to look again.
void Inflow::run() {
  bool more = true;
  is_running_ = true;
  for (int round = 0; round < rounds_at_once && more; ++round) {
    drain_();
    more = !is_stopped_ && is_readable();
  }
  is_running_ = false;
  if (!is_stopped_)
    more ? run_soon() : wait();
}

void Inflow::go_on() {
  if (!is_stopped_ && !is_running_ && !is_posted_)
    is_readable() ? run_soon() : wait();
}

void Inflow::wait() {
  watch_.await(socket_.get(zmq::sockopt::fd), POLLIN);
}

void Inflow::run_soon() {
  is_posted_ = true;
  loop_.post([this, life = std::weak_ptr<bool>(life_)] {
    if (life.expired())
      return;
    is_posted_ = false;
    if (!is_stopped_)
      run();
  });
}

bool Inflow::is_readable() const {
  return (socket_.get(zmq::sockopt::events) & ZMQ_POLLIN) != 0;
}

} // namespace parlour::adapters::agents
