// The functions are called under the lock of TcpSockets, and report events
// while it is held.
#include "adapters/network/tcp_connection.hpp"

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <unistd.h>

namespace parlour::adapters {

namespace {

using namespace std::chrono_literals;
using Kind = SocketEvent::Kind;

// For queued bytes after close().
constexpr auto closing_time = 2s;
// How much read() reads at once.
constexpr std::size_t piece = 16 << 10;

std::string words(int error) {
  return std::generic_category().message(error);
}

void set_up(int socket) {
  const int on = 1;
  // Small texts leave at once, and a dead peer is noticed some time. The
  // connection works without either.
  (void)setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  (void)setsockopt(socket, SOL_SOCKET, SO_KEEPALIVE, &on, sizeof on);
}

} // namespace

TcpConnection::TcpConnection(SocketOrder order, Sockets::Tell tell, Moment now)
    : order_(std::move(order)), tell_(std::move(tell)), framer_(order_.lines),
      deadline_(now + order_.timeout) {}

TcpConnection::~TcpConnection() {
  if (socket_ >= 0)
    ::close(socket_);
}

// -- opening ------------------------------------------------------------------

// endpoints_ is used from its end.
void TcpConnection::connect(std::vector<Endpoint> endpoints) {
  if (state_ != State::resolving)
    return;
  std::reverse(endpoints.begin(), endpoints.end());
  endpoints_ = std::move(endpoints);
  trouble_ = "it has no address";
  try_next();
}

// Starts to connect to the next address. A connect() that does not finish at
// once is finished by act().
void TcpConnection::try_next() {
  state_ = State::connecting;
  while (!endpoints_.empty()) {
    const auto endpoint = endpoints_.back();
    endpoints_.pop_back();
    if (socket_ >= 0)
      ::close(socket_);
    socket_ = socket(endpoint.address.ss_family,
                     SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    if (socket_ >= 0) {
      set_up(socket_);
      if (::connect(socket_,
                    reinterpret_cast<const sockaddr*>(&endpoint.address),
                    endpoint.size) == 0)
        return connected();
      if (errno == EINPROGRESS)
        return;
    }
    trouble_ = words(errno);
  }
  give_up("no connection to " + order_.address + ": " + trouble_);
}

void TcpConnection::connected() {
  state_ = State::open;
  deadline_ = Moment::max();
  trouble_.clear();
  tell_({Kind::opened});
}

void TcpConnection::give_up(const std::string& reason) {
  if (state_ != State::resolving && state_ != State::connecting)
    return;
  tell_({Kind::failed, reason});
  finish();
}

void TcpConnection::be_late() {
  if (state_ == State::closing)
    return finish();
  give_up("no connection to " + order_.address + " within " +
          std::to_string(order_.timeout.count()) + "ms");
}

// -- sending, closing ---------------------------------------------------------

Expected<void> TcpConnection::send(const std::string& text) {
  if (state_ != State::open || ended_)
    return fail(ErrorKind::network, "it is closed");
  if (unsent_.size() + text.size() > max_unsent)
    return fail(ErrorKind::network,
                "the other side does not take what is sent");
  unsent_ += text;
  return {};
}

// Sends as much as the system takes; poll says when there is room again.
void TcpConnection::write() {
  while (!unsent_.empty()) {
    const auto sent =
        ::send(socket_, unsent_.data(), unsent_.size(), MSG_NOSIGNAL);
    if (sent < 0 && (errno == EAGAIN || errno == EINTR))
      return;
    if (sent < 0)
      return end(words(errno));
    unsent_.erase(0, static_cast<std::size_t>(sent));
  }
  if (state_ == State::closing)
    finish();
}

void TcpConnection::close(Moment now) {
  tell_ = [](const SocketEvent&) {};
  if (state_ != State::open || ended_ || unsent_.empty())
    return finish();
  state_ = State::closing;
  deadline_ = now + closing_time;
}

void TcpConnection::finish() {
  state_ = State::over;
  if (socket_ >= 0)
    ::close(std::exchange(socket_, -1));
}

// -- reading ------------------------------------------------------------------

// One read for each event of poll: other connections have their turn, too.
void TcpConnection::read() {
  char bytes[piece];
  const auto got = recv(socket_, bytes, sizeof bytes, 0);
  if (got < 0 && (errno == EAGAIN || errno == EINTR))
    return;
  if (got <= 0)
    return end(got < 0 ? words(errno) : "the other side closed it");
  for (auto& text : framer_.take({bytes, static_cast<std::size_t>(got)}))
    texts_.push_back(std::move(text));
  deliver();
}

// The connection ends from the other side. What was read before is reported
// first, including a last line without a line break.
void TcpConnection::end(const std::string& reason) {
  if (state_ == State::closing)
    return finish();
  if (std::exchange(ended_, true))
    return;
  trouble_ = reason;
  if (auto rest = framer_.rest(); !rest.empty())
    texts_.push_back(std::move(rest));
  deliver();
}

// Reports texts as far as flow control allows. The end is reported after the
// last text.
void TcpConnection::deliver() {
  while (!texts_.empty() && untaken_ < max_untaken) {
    ++untaken_;
    tell_({Kind::text, std::move(texts_.front())});
    texts_.pop_front();
  }
  if (ended_ && texts_.empty() && state_ == State::open) {
    tell_({Kind::closed, trouble_});
    finish();
  }
}

void TcpConnection::taken() {
  if (untaken_ > 0)
    --untaken_;
  if (state_ == State::open)
    deliver();
}

// -- waiting ------------------------------------------------------------------

// Reading stops while texts wait to be reported or taken.
short TcpConnection::interest() const {
  if (state_ == State::connecting || state_ == State::closing)
    return POLLOUT;
  if (state_ != State::open || ended_)
    return 0;
  const bool reads = texts_.empty() && untaken_ < max_untaken;
  return static_cast<short>((reads ? POLLIN : 0) |
                            (unsent_.empty() ? 0 : POLLOUT));
}

void TcpConnection::act(short ready) {
  if (ready == 0)
    return;
  // SO_ERROR is the outcome of a connect() that did not finish at once.
  if (state_ == State::connecting) {
    int error = 0;
    socklen_t size = sizeof error;
    if (getsockopt(socket_, SOL_SOCKET, SO_ERROR, &error, &size) != 0)
      error = errno;
    if (error == 0)
      return connected();
    trouble_ = words(error);
    return try_next();
  }
  const auto wanted = interest();
  if (wanted & POLLOUT)
    write();
  if ((wanted & POLLIN) && (ready & ~POLLOUT) && state_ == State::open)
    read();
}

} // namespace parlour::adapters
