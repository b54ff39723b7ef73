#include "adapters/process/frame_socket.hpp"

#include <algorithm>
#include <cerrno>
#include <iterator>
#include <utility>

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace parlour::adapters {

namespace {

constexpr std::size_t piece = 64 << 10;

bool is_to_come(int error) {
  return error == EAGAIN || error == EWOULDBLOCK || error == EINTR;
}

// As poll wants it: rounded up, -1 for ever.
int milliseconds_until(std::optional<FrameSocket::Moment> deadline) {
  if (!deadline)
    return -1;
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(
      *deadline - FrameSocket::Moment::clock::now());
  return static_cast<int>(std::clamp<std::int64_t>(left.count(), 0, 60'000));
}

tl::unexpected<Error> closed() {
  return fail(ErrorKind::offline, "it has closed its connection");
}

} // namespace

FrameSocket::~FrameSocket() {
  ::close(descriptor_);
}

Expected<void> FrameSocket::send(const Frame& frame,
                                 std::optional<Moment> deadline) {
  const auto bytes = frame_bytes(frame);
  if (!bytes)
    return tl::make_unexpected(bytes.error());
  std::lock_guard lock(sending_);
  return send_all(*bytes, deadline);
}

Expected<void> FrameSocket::send_all(std::string_view bytes,
                                     std::optional<Moment> deadline) const {
  while (!bytes.empty()) {
    const auto sent = ::send(descriptor_, bytes.data(), bytes.size(),
                             MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent >= 0)
      bytes.remove_prefix(static_cast<std::size_t>(sent));
    else if (!is_to_come(errno))
      return closed();
    else if (!wait_to_send(deadline))
      return fail(ErrorKind::timeout, "it does not take what is sent to it");
  }
  return {};
}

bool FrameSocket::wait_to_send(std::optional<Moment> deadline) const {
  pollfd ready{descriptor_, POLLOUT, 0};
  poll(&ready, 1, milliseconds_until(deadline));
  return !deadline || Moment::clock::now() < *deadline;
}

Expected<std::vector<Frame>> FrameSocket::receive() {
  char bytes[piece];
  const auto got = recv(descriptor_, bytes, sizeof bytes, MSG_DONTWAIT);
  if (got == 0 || (got < 0 && !is_to_come(errno)))
    return closed();
  if (got > 0)
    reader_.add({bytes, static_cast<std::size_t>(got)});
  std::vector<Frame> frames;
  for (;;) {
    auto frame = reader_.next();
    if (!frame)
      return tl::make_unexpected(frame.error());
    if (!*frame)
      return frames;
    frames.push_back(std::move(**frame));
  }
}

void FrameSocket::wait(int other, int another) const {
  pollfd ready[] = {
      {descriptor_, POLLIN, 0}, {other, POLLIN, 0}, {another, POLLIN, 0}};
  poll(ready, std::size(ready), -1);
}

void FrameSocket::shut_down() {
  ::shutdown(descriptor_, SHUT_RDWR);
}

} // namespace parlour::adapters
