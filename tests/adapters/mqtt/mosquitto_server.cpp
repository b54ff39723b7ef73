#include "tests/adapters/mqtt/mosquitto_server.hpp"

#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <utility>

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace parlour::test {

namespace {

// A port that was free a moment ago: mosquitto cannot be given a socket.
std::uint16_t free_port() {
  const int probe = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  auto* raw = reinterpret_cast<sockaddr*>(&address);
  const bool found =
      bind(probe, raw, size) == 0 && getsockname(probe, raw, &size) == 0;
  close(probe);
  if (!found)
    throw std::runtime_error("no port is free");
  return ntohs(address.sin_port);
}

} // namespace

std::filesystem::path MosquittoServer::program() {
  for (const auto* place : {"/usr/sbin/mosquitto", "/usr/bin/mosquitto"})
    if (std::filesystem::exists(place))
      return place;
  return {};
}

MosquittoServer::MosquittoServer(std::string settings)
    : settings_(std::move(settings)) {
  const std::string mark = "FOLDER";
  for (auto at = settings_.find(mark); at != std::string::npos;
       at = settings_.find(mark))
    settings_.replace(at, mark.size(), folder().string());
}

MosquittoServer::~MosquittoServer() {
  kill();
}

// Another program may take the port before the server does.
void MosquittoServer::start() {
  for (int attempt = 0; attempt < 20; ++attempt) {
    if (port_ == 0)
      port_ = free_port();
    write_settings();
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0)
      throw std::runtime_error("no pipe can be made");
    launch(ends[1]);
    close(ends[1]);
    const bool ready = is_ready(ends[0]);
    close(ends[0]);
    if (ready)
      return;
    kill();
    port_ = 0;
  }
  throw std::runtime_error("mosquitto does not start: " + said_);
}

void MosquittoServer::write_settings() const {
  folder_.write("mosquitto.conf",
                "user root\npersistence false\nlog_dest stderr\nlistener " +
                    std::to_string(port_) + " 127.0.0.1\n" + settings_);
}

void MosquittoServer::launch(int output) {
  const auto name = program().string();
  const auto settings = (folder() / "mosquitto.conf").string();
  process_ = fork();
  if (process_ != 0)
    return;
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  dup2(output, STDOUT_FILENO);
  dup2(output, STDERR_FILENO);
  execl(name.c_str(), name.c_str(), "-c", settings.c_str(), nullptr);
  _exit(127);
}

bool MosquittoServer::is_ready(int log) {
  said_.clear();
  char bytes[4096];
  while (said_.find(" running") == std::string::npos) {
    const auto count = read(log, bytes, sizeof bytes);
    if (count <= 0)
      return false;
    said_.append(bytes, static_cast<std::size_t>(count));
  }
  return true;
}

void MosquittoServer::kill() {
  if (process_ <= 0)
    return;
  ::kill(process_, SIGKILL);
  waitpid(std::exchange(process_, -1), nullptr, 0);
}

void MosquittoServer::add_user(const std::string& user,
                               const std::string& password) const {
  const auto file = (folder() / "users").string();
  const auto process = fork();
  if (process == 0) {
    execlp("mosquitto_passwd", "mosquitto_passwd", "-c", "-b", file.c_str(),
           user.c_str(), password.c_str(), nullptr);
    _exit(127);
  }
  int status = 0;
  waitpid(process, &status, 0);
  if (status != 0)
    throw std::runtime_error("mosquitto_passwd fails");
}

} // namespace parlour::test
