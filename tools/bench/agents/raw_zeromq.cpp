#include "tools/bench/agents/raw_zeromq.hpp"

#include <chrono>
#include <string>
#include <thread>

#include <zmq.hpp>

namespace parlour::tools {

namespace {

using Clock = std::chrono::steady_clock;

// Messages that may wait, so that neither side does.
constexpr int many = 100'000;

void set_limits(zmq::socket_t& socket) {
  socket.set(zmq::sockopt::sndhwm, many);
  socket.set(zmq::sockopt::rcvhwm, many);
  socket.set(zmq::sockopt::linger, 0);
}

void send(zmq::socket_t& socket, int frames) {
  static const std::string text(exchanged_bytes, 'x');
  for (int i = 1; i < frames; ++i)
    socket.send(zmq::buffer(text.data(), 8), zmq::send_flags::sndmore);
  socket.send(zmq::buffer(text), zmq::send_flags::none);
}

void receive(zmq::socket_t& socket) {
  zmq::message_t frame;
  do
    (void)socket.recv(frame);
  while (frame.more());
}

// Sends one message back, frame by frame.
void echo(zmq::socket_t& socket) {
  zmq::message_t frame;
  bool more = true;
  while (more) {
    (void)socket.recv(frame);
    more = frame.more();
    socket.send(frame, more ? zmq::send_flags::sndmore : zmq::send_flags::none);
  }
}

void one_way(Exchanged& exchanged, zmq::context_t& near, zmq::context_t& far,
             int frames, std::size_t count) {
  zmq::socket_t pull(far, zmq::socket_type::pull);
  set_limits(pull);
  pull.bind("tcp://127.0.0.1:*");
  std::thread other([&] {
    for (std::size_t i = 0; i < count; ++i)
      receive(pull);
  });
  zmq::socket_t push(near, zmq::socket_type::push);
  set_limits(push);
  push.connect(pull.get(zmq::sockopt::last_endpoint));
  const StopWatch watch(0);
  for (std::size_t i = 0; i < count; ++i)
    send(push, frames);
  other.join();
  set_one_way(exchanged, watch, count);
}

std::vector<double> round_trips(zmq::context_t& near, zmq::context_t& far,
                                int frames, std::size_t count) {
  zmq::socket_t router(far, zmq::socket_type::router);
  set_limits(router);
  router.bind("tcp://127.0.0.1:*");
  std::thread other([&] {
    for (std::size_t i = 0; i < count; ++i)
      echo(router);
  });
  zmq::socket_t dealer(near, zmq::socket_type::dealer);
  set_limits(dealer);
  dealer.connect(router.get(zmq::sockopt::last_endpoint));
  std::vector<double> times;
  for (std::size_t i = 0; i < count; ++i) {
    const auto start = Clock::now();
    send(dealer, frames);
    receive(dealer);
    times.push_back(
        std::chrono::duration<double, std::micro>(Clock::now() - start)
            .count());
  }
  other.join();
  return times;
}

} // namespace

Expected<Exchanged> raw_zeromq_exchange(const RawZeroMQ& way,
                                        const ExchangeCount& count) {
  try {
    Exchanged exchanged;
    zmq::context_t one;
    zmq::context_t two;
    auto& far = way.share_thread ? one : two;
    one_way(exchanged, one, far, way.frames, count.messages);
    set_round_trips(exchanged,
                    round_trips(one, far, way.frames, count.round_trips));
    return exchanged;
  } catch (const zmq::error_t& error) {
    return fail(ErrorKind::network, error.what());
  }
}

} // namespace parlour::tools
