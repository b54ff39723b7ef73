// Inflow has the messages of a ZeroMQ socket taken on a loop. An internal
// header of this folder.
#pragma once

#include <functional>
#include <memory>

#include <zmq.hpp>

#include "adapters/loop/watch.hpp"

namespace parlour::adapters::agents {

// Runs `drain` on a loop whenever a socket of ZeroMQ has messages. ZeroMQ's
// descriptor is edge-triggered: it reports changes only, and any use of the
// socket may swallow one. So after each use of the socket go_on() must be
// called, which looks at the socket's state itself. Used on the loop's thread
// only.
class Inflow {
public:
  // `drain` takes one message or more; it is called again if there are more. It
  // may write, and may call stop().
  Inflow(Loop& loop, zmq::socket_t& socket, std::function<void()> drain);
  Inflow(const Inflow&) = delete;
  Inflow& operator=(const Inflow&) = delete;

  // Nothing is waited for any more.
  void stop();
  // Has `drain` run soon if there are messages, otherwise waits for a change.
  // Soon and not at once: other work of the loop has its turn.
  void go_on();

private:
  void run();
  void run_soon();
  void wait();
  bool is_readable() const;

  Loop& loop_;
  Watch watch_;
  zmq::socket_t& socket_;
  const std::function<void()> drain_;
  bool is_stopped_ = false;
  // run() is under way, and will look at the socket at its end.
  bool is_running_ = false;
  // run() has been posted.
  bool is_posted_ = false;
  // What is posted runs only while it is there.
  const std::shared_ptr<bool> life_ = std::make_shared<bool>();
};

} // namespace parlour::adapters::agents
