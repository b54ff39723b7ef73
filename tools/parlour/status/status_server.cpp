#include "tools/parlour/status/status_server.hpp"

#include <cerrno>
#include <chrono>
#include <cstring>
#include <string_view>
#include <utility>

#include <sys/eventfd.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <sys/un.h>
#include <unistd.h>

#include "adapters/loop/wait_until_ready.hpp"
#include "runtime/base/clock.hpp"
#include "tools/parlour/status/running_nodes.hpp"
#include "tools/parlour/status/runtime_folder.hpp"

namespace parlour::tools {

namespace fs = std::filesystem;

namespace {

// Who connects and neither asks nor reads is let go.
constexpr timeval patience{1, 0};
constexpr std::size_t max_question = 4'096;
constexpr int backlog = 4;
// While the process has no descriptors left, whoever connects stays in the
// queue, and accepting fails at once, again and again.
constexpr Milliseconds pause_between{200};

tl::unexpected<Error> trouble(const fs::path& path) {
  return fail(ErrorKind::file,
              "the socket " + path.string() + ": " + std::strerror(errno));
}

Expected<int> listen_at(const fs::path& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.string().size() >= sizeof address.sun_path)
    return fail(ErrorKind::file,
                "the socket " + path.string() + ": its name is too long");
  path.string().copy(address.sun_path, sizeof address.sun_path - 1);
  const int listener = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (listener < 0)
    return trouble(path);
  unlink(path.c_str()); // of an earlier process with this number
  if (bind(listener, reinterpret_cast<sockaddr*>(&address), sizeof address) ==
          0 &&
      listen(listener, backlog) == 0)
    return listener;
  const auto error = trouble(path);
  close(listener);
  return error;
}

// A line, without its end.
std::string question_of(const Descriptor& connection) {
  std::string text;
  char byte = 0;
  while (text.size() < max_question &&
         recv(connection.get(), &byte, 1, 0) == 1 && byte != '\n')
    text += byte;
  return text;
}

} // namespace

Expected<std::unique_ptr<StatusServer>>
StatusServer::open(const fs::path& folder, Tell tell, TakenWords taken) {
  if (auto made = make_runtime_folder(folder); !made)
    return tl::make_unexpected(made.error());
  auto path = folder / (std::to_string(getpid()) + ".sock");
  const int stop = eventfd(0, EFD_CLOEXEC);
  if (stop < 0)
    return fail(ErrorKind::limit, std::strerror(errno));
  const auto listener = listen_at(path);
  if (!listener) {
    close(stop);
    return tl::make_unexpected(listener.error());
  }
  return std::unique_ptr<StatusServer>(new StatusServer(
      std::move(path), *listener, stop, std::move(tell), std::move(taken)));
}

StatusServer::StatusServer(fs::path path, int listener, int stop, Tell tell,
                           TakenWords taken)
    : path_(std::move(path)), listener_(listener), stop_(stop),
      tell_(std::move(tell)), taken_(std::move(taken)),
      thread_([this] { serve(); }) {}

StatusServer::~StatusServer() {
  eventfd_write(stop_, 1);
  thread_.join();
  unlink(path_.c_str());
  close(listener_);
  close(stop_);
}

void StatusServer::serve() {
  pollfd waiting[] = {{stop_, POLLIN, 0}, {listener_, POLLIN, 0}};
  while (adapters::wait_until_ready(waiting) != adapters::Waited::failed) {
    if (waiting[0].revents != 0)
      return;
    if (waiting[1].revents == 0)
      continue;
    Descriptor connection(accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC));
    if (connection)
      answer(std::move(connection));
    else
      pause();
  }
}

// Ends early where the server is to end.
void StatusServer::pause() const {
  pollfd stop[] = {{stop_, POLLIN, 0}};
  adapters::wait_until_ready(stop,
                             std::chrono::steady_clock::now() + pause_between);
}

void StatusServer::answer(Descriptor connection) const {
  for (const int what : {SO_SNDTIMEO, SO_RCVTIMEO})
    setsockopt(connection.get(), SOL_SOCKET, what, &patience, sizeof patience);
  const auto question = question_of(connection);
  const auto blank = question.find(' ');
  const auto word = taken_.find(question.substr(0, blank));
  if (blank != std::string::npos && word != taken_.end())
    return word->second(std::move(connection), question.substr(blank + 1));
  send_all(connection, tell_(question));
}

void send_all(const Descriptor& connection, std::string_view text) {
  while (!text.empty()) {
    const auto sent =
        send(connection.get(), text.data(), text.size(), MSG_NOSIGNAL);
    if (sent <= 0)
      return;
    text.remove_prefix(static_cast<std::size_t>(sent));
  }
}

} // namespace parlour::tools
