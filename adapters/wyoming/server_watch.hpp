// ServerWatch knows whether a Wyoming server is there and offers a service. It
// keeps a connection of its own, on which it asks now and then, and tries again
// after growing pauses if there is none.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "adapters/loop/backoff.hpp"
#include "adapters/wyoming/connection.hpp"

namespace parlour::adapters::wyoming {

// `answer_timeout` limits the answer of the server, `ask_every` the time
// between two questions.
struct WatchOptions {
  std::string service; // "asr", "tts", "wake"
  Milliseconds answer_timeout{10'000};
  Milliseconds first_pause{1'000};
  Milliseconds ask_every{30'000};
};

// Told on the loop's thread; only changes are told, and every reason.
struct WatchCalls {
  std::function<void()> up;
  std::function<void(const std::string& reason)> down;
};

// Used on the loop's thread only, destroyed like an Alarm.
// The service is one of the protocol's: a server that only speaks is of no use
// to a recogniser.
class ServerWatch {
public:
  ServerWatch(const Route& route, WatchOptions options, WatchCalls calls);

  void start();
  bool is_up() const {
    return is_up_;
  }

private:
  void ask();
  void received(const Event& event);
  // Ends the connection and tries again after the pause.
  void lose(const std::string& reason);
  void rung();

  const Route& route_;
  const WatchOptions options_;
  const WatchCalls calls_;
  std::unique_ptr<Connection> connection_;
  // For the next question, for the end of this one, or to connect again.
  Alarm alarm_;
  Backoff backoff_;
  bool is_up_ = false;
  bool is_asked_ = false;
};

} // namespace parlour::adapters::wyoming
