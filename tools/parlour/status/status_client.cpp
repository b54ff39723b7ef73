#include "tools/parlour/status/status_client.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string>

#include <sys/socket.h>
#include <sys/time.h>
#include <sys/un.h>
#include <unistd.h>

namespace parlour::tools {

namespace fs = std::filesystem;

namespace {

// Longer than a node waits for its actors.
constexpr timeval patience{3, 0};

class Connection {
public:
  Connection() : socket_(socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;
  ~Connection() {
    if (socket_ >= 0)
      close(socket_);
  }

  bool open(const fs::path& path) const {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    path.string().copy(address.sun_path, sizeof address.sun_path - 1);
    return connect(socket_, reinterpret_cast<sockaddr*>(&address),
                   sizeof address) == 0;
  }
  // All until the other end closes; nothing where that does not come in time.
  std::optional<std::string> read_all() const {
    std::string text;
    char buffer[4096];
    for (;;) {
      const auto size = read(socket_, buffer, sizeof buffer);
      if (size == 0)
        return text;
      if (size < 0 && errno != EINTR)
        return std::nullopt;
      if (size > 0)
        text.append(buffer, static_cast<std::size_t>(size));
    }
  }

private:
  const int socket_;
};

std::vector<fs::path> sockets_in(const fs::path& folder) {
  std::vector<fs::path> all;
  std::error_code code;
  for (const auto& entry : fs::directory_iterator(folder, code))
    if (entry.path().extension() == ".sock")
      all.push_back(entry.path());
  std::ranges::sort(all, {}, [](const fs::path& path) {
    return std::atol(path.stem().c_str());
  });
  return all;
}

// Nothing where nobody is there any more.
std::optional<Expected<StatusReport>> ask(const fs::path& path) {
  const Connection connection;
  if (!connection.open(path)) {
    if (errno == ECONNREFUSED)
      unlink(path.c_str());
    return std::nullopt;
  }
  const auto text = connection.read_all();
  if (!text)
    return fail(ErrorKind::timeout,
                "process " + path.stem().string() + " does not say how it is");
  return report_from_json(*text);
}

} // namespace

std::vector<Expected<StatusReport>> ask_status(const fs::path& folder) {
  std::vector<Expected<StatusReport>> all;
  for (const auto& path : sockets_in(folder))
    if (auto told = ask(path))
      all.push_back(std::move(*told));
  return all;
}

} // namespace parlour::tools
