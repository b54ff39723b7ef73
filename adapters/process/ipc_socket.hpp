// IpcSocket is one end of the socket pair between the platform and a
// component's process. It sends and receives whole messages.
#pragma once

#include <chrono>
#include <mutex>
#include <optional>
#include <string_view>
#include <vector>

#include "adapters/process/ipc_message.hpp"

namespace parlour::adapters {

// Any thread may send; one thread receives.
class IpcSocket {
public:
  using Moment = std::chrono::steady_clock::time_point;

  // Takes ownership of the descriptor.
  explicit IpcSocket(int descriptor) : descriptor_(descriptor) {}
  IpcSocket(const IpcSocket&) = delete;
  IpcSocket& operator=(const IpcSocket&) = delete;
  ~IpcSocket();

  // Blocks until the message has been handed to the system; without a deadline
  // for as long as that takes. The kind of an error is Limit (the message is
  // too long and was not sent), Timeout (the other end does not read) or
  // Offline.
  Expected<void> send(const IpcMessage& message,
                      std::optional<Moment> deadline = {});

  // Returns the messages that have arrived, perhaps none, without blocking. The
  // kind of an error is Offline (the other end is closed and everything was
  // received) or Network (the bytes are no messages).
  Expected<std::vector<IpcMessage>> receive();
  // Blocks until there is something to receive, or one of two further
  // descriptors (-1: none) can be read.
  void wait(int other = -1, int another = -1) const;

  // Closes both directions. Thread-safe; the other end sees a closed
  // connection.
  void shut_down();

private:
  Expected<void> send_all(std::string_view bytes,
                          std::optional<Moment> deadline) const;
  bool wait_to_send(std::optional<Moment> deadline) const;

  const int descriptor_;
  // Keeps the bytes of one message together.
  std::mutex sending_;
  IpcReader reader_;
};

} // namespace parlour::adapters
