// TextClients: many visitors of a text server (text_server.hpp) on one thread,
// for tools that try it: `parlour load`.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>

#include "runtime/base/error.hpp"

namespace parlour::adapters::web {

// One visitor's end. Called on the thread that runs the clients.
// Implemented by the tool; may destroy its link in any of these calls.
class Client {
public:
  virtual ~Client() = default;
  virtual void opened() = 0; // it may be sent something
  virtual void heard(const std::string& message) = 0;
  // The connection is over, or has not come to be. Nothing follows.
  virtual void closed(const std::string& why) = 0;
};

// An open connection, or one that is being opened; to destroy it closes it.
class ClientLink {
public:
  virtual ~ClientLink() = default;
  virtual void send(std::string message) = 0;
};

// Thousands of visitors need no thread each, so that the tool does not measure
// itself.
class TextClients {
public:
  using Moment = std::chrono::steady_clock::time_point;
  enum class By : bool { lines, frames };

  static Expected<std::unique_ptr<TextClients>> start();
  virtual ~TextClients() = default;

  // Calls what is due until stop() is called.
  virtual void run() = 0;
  // From any thread.
  virtual void stop() = 0;

  // The rest is for the thread that runs them, or before it does. `client` must
  // live until closed(), or until the link is destroyed.
  // Returns at once; opened() or closed() follows.
  virtual std::unique_ptr<ClientLink> connect(const std::string& address,
                                              std::uint16_t port, By by,
                                              Client& client) = 0;
  virtual void at(Moment moment, std::function<void()> action) = 0;
};

} // namespace parlour::adapters::web
