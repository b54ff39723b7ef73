// Connection is one TCP connection to a Wyoming server.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "adapters/loop/alarm.hpp"
#include "adapters/network/address.hpp"
#include "adapters/network/resolver.hpp"
#include "adapters/wyoming/event.hpp"
#include "runtime/base/clock.hpp"

namespace parlour::adapters::wyoming {

// Where connections are made, and how long connecting may take.
struct Route {
  Loop& loop;
  Resolver& resolver;
  Address address;
  Milliseconds connect_timeout{5'000};
};

// What a connection tells, on the loop's thread.
struct ConnectionCalls {
  std::function<void(Event event)> received;
  // It could not be opened, has ended, or said nothing in time. The last call.
  std::function<void(const std::string& reason)> closed;
};

// It knows events and time limits, and nothing of what they mean. A connection
// that is closed stays closed: whoever wants another makes one.
// Used on the loop's thread only, destroyed like an Alarm.
class Connection {
public:
  // How much may wait to be sent, in bytes; more closes the connection.
  // Half a minute of speech.
  static constexpr std::size_t max_unsent = 1 << 20;
  // How much of what is sent the system may keep beyond that.
  static constexpr int system_buffer = 64 << 10;

  // Begins to connect. The route outlives the connection.
  Connection(const Route& route, ConnectionCalls calls);
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;
  // Nothing is told any more.
  ~Connection();

  // What is sent before the connection is open waits for it.
  // One that is closed sends nothing, and says nothing about it.
  void send(const Event& event);
  // If nothing is received within the time, the connection is closed. Zero: no
  // limit.
  void expect(Milliseconds within);
  // Until resume(), nothing more is read, so that TCP slows the server down.
  // What has been read is still received: the events that end in the last
  // 16 KiB.
  void pause();
  void resume();

private:
  struct State;
  const std::shared_ptr<State> state_;
};

} // namespace parlour::adapters::wyoming
