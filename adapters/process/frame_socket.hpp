// FrameSocket: one end of the socket pair between a component's process and
// ours: frames in, frames out.
#pragma once

#include <chrono>
#include <mutex>
#include <optional>
#include <string_view>
#include <vector>

#include "adapters/process/frames.hpp"

namespace parlour::adapters {

// Any thread may send; one receives.
class FrameSocket {
public:
  using Moment = std::chrono::steady_clock::time_point;

  // Owns the descriptor.
  explicit FrameSocket(int descriptor) : descriptor_(descriptor) {}
  FrameSocket(const FrameSocket&) = delete;
  FrameSocket& operator=(const FrameSocket&) = delete;
  ~FrameSocket();

  // Until it is on its way; nothing: as long as that takes. An error is of kind
  // Limit (too long, nothing was sent), Timeout (nobody reads) or Offline.
  Expected<void> send(const Frame& frame, std::optional<Moment> deadline = {});

  // What is there, without waiting. An error is of kind Offline, where the
  // other end is closed and all of it was received, or Network: rubbish.
  Expected<std::vector<Frame>> receive();
  // Until there is something, or one of the others (-1: none) can be read.
  void wait(int other = -1, int another = -1) const;

  // Both ways, from any thread; the other end sees it as closed.
  void shut_down();

private:
  Expected<void> send_all(std::string_view bytes,
                          std::optional<Moment> deadline) const;
  bool wait_to_send(std::optional<Moment> deadline) const;

  const int descriptor_;
  std::mutex sending_;
  FrameReader reader_;
};

} // namespace parlour::adapters
