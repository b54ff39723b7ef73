// MessageTap publishes a copy of each message to whoever listens
// (adapters/agents/PROTOCOL.md 6). It influences nothing: for a listener that
// is too slow messages are left out.
#pragma once

#include <memory>
#include <string>

#include "runtime/base/error.hpp"
#include "runtime/message/message.hpp"

namespace parlour::adapters::agents {

class MessageTap {
public:
  // `address`: "tcp://127.0.0.1:5673"; `*` as the port: any that is free. The
  // kind of an error is Settings if other hosts could listen, and Network if
  // the address is in use.
  static Expected<std::unique_ptr<MessageTap>> open(const std::string& address);
  ~MessageTap();

  // Where listeners connect, with the port that was chosen.
  std::string address() const;
  // Never blocks. From any thread, one call at a time.
  void publish(const Message& message);

private:
  struct Socket;
  explicit MessageTap(std::unique_ptr<Socket> socket);
  std::unique_ptr<Socket> socket_;
};

} // namespace parlour::adapters::agents
