#include "tools/bench/agents/raw_tcp.hpp"

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

namespace parlour::tools {

namespace {

using Clock = std::chrono::steady_clock;
using Message = std::array<char, exchanged_bytes>;
using Block = std::array<char, 64 << 10>;

// Closes its descriptor.
class Socket {
public:
  explicit Socket(int descriptor) : descriptor_(descriptor) {}
  Socket(Socket&& other) noexcept
      : descriptor_(std::exchange(other.descriptor_, -1)) {}
  Socket& operator=(Socket&&) = delete;
  ~Socket() {
    if (descriptor_ >= 0)
      close(descriptor_);
  }
  int descriptor() const {
    return descriptor_;
  }
  bool is_open() const {
    return descriptor_ >= 0;
  }

private:
  int descriptor_;
};

struct Pair {
  Socket near;
  Socket far;
};

// Small messages leave at once.
void without_delay(const Socket& socket) {
  const int on = 1;
  setsockopt(socket.descriptor(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
}

// Two ends of a connection over loopback.
Expected<Pair> connected_pair() {
  const Socket listener(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  sockaddr_in end{};
  end.sin_family = AF_INET;
  end.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof end;
  auto* address = reinterpret_cast<sockaddr*>(&end);
  Socket near(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  if (bind(listener.descriptor(), address, size) != 0 ||
      listen(listener.descriptor(), 1) != 0 ||
      getsockname(listener.descriptor(), address, &size) != 0 ||
      connect(near.descriptor(), address, size) != 0)
    return fail(ErrorKind::network, std::strerror(errno));
  Socket far(accept4(listener.descriptor(), nullptr, nullptr, SOCK_CLOEXEC));
  if (!far.is_open())
    return fail(ErrorKind::network, std::strerror(errno));
  without_delay(near);
  without_delay(far);
  return Pair{std::move(near), std::move(far)};
}

// False: the other side has gone.
template <class Bytes>
bool write_all(const Socket& socket, const Bytes& bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const auto size =
        write(socket.descriptor(), bytes.data() + done, bytes.size() - done);
    if (size <= 0)
      return false;
    done += static_cast<std::size_t>(size);
  }
  return true;
}

template <class Bytes>
bool read_all(const Socket& socket, Bytes& bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const auto size =
        read(socket.descriptor(), bytes.data() + done, bytes.size() - done);
    if (size <= 0)
      return false;
    done += static_cast<std::size_t>(size);
  }
  return true;
}

void echo(const Socket& socket) {
  Message message{};
  while (read_all(socket, message) && write_all(socket, message)) {
  }
}

// Reads until the other side has closed the connection.
std::size_t count_bytes(const Socket& socket) {
  static thread_local Block block;
  std::size_t all = 0;
  for (;;) {
    const auto size = read(socket.descriptor(), block.data(), block.size());
    if (size <= 0)
      return all;
    all += static_cast<std::size_t>(size);
  }
}

Expected<std::vector<double>> round_trips(std::size_t count) {
  auto pair = connected_pair();
  if (!pair)
    return tl::make_unexpected(pair.error());
  std::thread other([&] { echo(pair->far); });
  std::vector<double> times;
  Message message{};
  for (std::size_t i = 0; i < count; ++i) {
    const auto start = Clock::now();
    if (!write_all(pair->near, message) || !read_all(pair->near, message))
      break;
    times.push_back(
        std::chrono::duration<double, std::micro>(Clock::now() - start)
            .count());
  }
  shutdown(pair->near.descriptor(), SHUT_WR);
  other.join();
  return times;
}

Expected<void> one_way(Exchanged& exchanged, std::size_t messages) {
  auto pair = connected_pair();
  if (!pair)
    return tl::make_unexpected(pair.error());
  std::size_t arrived = 0;
  std::thread other([&] { arrived = count_bytes(pair->far); });
  static const Block block{};
  const StopWatch watch(0);
  for (std::size_t i = 0; i < messages * exchanged_bytes / block.size(); ++i)
    write_all(pair->near, block);
  shutdown(pair->near.descriptor(), SHUT_WR);
  other.join();
  set_one_way(exchanged, watch, arrived / exchanged_bytes);
  return {};
}

} // namespace

Expected<Exchanged> raw_tcp_exchange(const ExchangeCount& count) {
  Exchanged exchanged;
  if (auto measured = one_way(exchanged, count.messages); !measured)
    return tl::make_unexpected(measured.error());
  auto times = round_trips(count.round_trips);
  if (!times)
    return tl::make_unexpected(times.error());
  set_round_trips(exchanged, std::move(*times));
  return exchanged;
}

} // namespace parlour::tools
