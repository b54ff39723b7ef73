#include "adapters/process/ipc_socket.hpp"

#include <cerrno>
#include <utility>

#include <sys/socket.h>
#include <unistd.h>

#include "adapters/loop/wait_until_ready.hpp"

namespace parlour::adapters {

namespace {

// How much receive() reads at once.
constexpr std::size_t piece = 64 << 10;

// The error means that nothing can be done now, not that the connection is
// closed.
bool is_to_come(int error) {
  return error == EAGAIN || error == EWOULDBLOCK || error == EINTR;
}

tl::unexpected<Error> closed() {
  return fail(ErrorKind::offline, "it has closed its connection");
}

} // namespace

IpcSocket::~IpcSocket() {
  ::close(descriptor_);
}

Expected<void> IpcSocket::send(const IpcMessage& message,
                               std::optional<Moment> deadline) {
  const auto bytes = ipc_bytes(message);
  if (!bytes)
    return tl::make_unexpected(bytes.error());
  std::lock_guard lock(sending_);
  return send_all(*bytes, deadline);
}

Expected<void> IpcSocket::send_all(std::string_view bytes,
                                   std::optional<Moment> deadline) const {
  // The socket takes as much as it has room for. MSG_NOSIGNAL: a closed socket
  // is an error, not a signal.
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

// False if the deadline has passed, even if there is room again.
bool IpcSocket::wait_to_send(std::optional<Moment> deadline) const {
  const auto until = deadline.value_or(Moment::max());
  pollfd awaited[] = {{descriptor_, POLLOUT, 0}};
  return wait_until_ready(awaited, until) == Waited::ready &&
         Moment::clock::now() < until;
}

Expected<std::vector<IpcMessage>> IpcSocket::receive() {
  char bytes[piece];
  const auto got = recv(descriptor_, bytes, sizeof bytes, MSG_DONTWAIT);
  if (got == 0 || (got < 0 && !is_to_come(errno)))
    return closed();
  if (got > 0)
    reader_.add({bytes, static_cast<std::size_t>(got)});
  // One read may complete several messages, or none.
  std::vector<IpcMessage> messages;
  for (;;) {
    auto message = reader_.next();
    if (!message)
      return tl::make_unexpected(message.error());
    if (!*message)
      return messages;
    messages.push_back(std::move(**message));
  }
}

void IpcSocket::wait(int other, int another) const {
  pollfd awaited[] = {
      {descriptor_, POLLIN, 0}, {other, POLLIN, 0}, {another, POLLIN, 0}};
  wait_until_ready(awaited);
}

void IpcSocket::shut_down() {
  ::shutdown(descriptor_, SHUT_RDWR);
}

} // namespace parlour::adapters
