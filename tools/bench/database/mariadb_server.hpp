// MariaDBServer is a private MariaDB server for benches and tests. Its data lie
// in the given folder; it listens on a socket there and on no port, and needs
// no login. It is killed when the thread that started it ends.
//
//  MariaDBServer server(folder);
//  if (auto started = server.start(); !started)
//    return started.error(); // with the server's log
//  options["socket"] = server.socket();
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <sys/types.h>

#include "runtime/base/error.hpp"

namespace parlour::tools {

struct MariaDBServerOptions {
  // Arguments in addition to those that every such server gets.
  std::vector<std::string> arguments;
  // Listen on a free port of this machine instead of the socket.
  bool on_port = false;
  // Require a login: root without a password, and accounts that root creates.
  bool has_users = false;
};

// Not thread-safe.
class MariaDBServer {
public:
  // The path of the server's program; empty if it is not installed.
  static std::filesystem::path program();

  explicit MariaDBServer(std::filesystem::path folder,
                         MariaDBServerOptions options = {});
  MariaDBServer(const MariaDBServer&) = delete;
  MariaDBServer& operator=(const MariaDBServer&) = delete;
  ~MariaDBServer();

  // Starts the server and waits until it accepts connections. Does nothing if
  // it runs. The error, of kind Offline, has the server's own words.
  Expected<void> start();

  // Ends the server at once, as a loss of power would.
  void kill();
  // Ends it in order; running statements are ended.
  void stop();
  // Stops it without ending it: it is there but does not answer. go_on()
  // resumes it.
  void pause();
  void go_on();

  std::string socket() const;
  // -1 if it does not run.
  int process() const {
    return process_;
  }
  // 0 if it listens on none.
  unsigned port() const {
    return port_;
  }

private:
  std::vector<std::string> arguments() const;
  Expected<void> make_users();
  void launch(const std::vector<std::string>& arguments, int input, int output);
  [[noreturn]] void become(const std::vector<std::string>& arguments, int input,
                           int output) const;
  void end(int signal);

  std::filesystem::path folder_;
  MariaDBServerOptions options_;
  // The socket of the port.
  int listener_ = -1;
  unsigned port_ = 0;
  pid_t process_ = -1;
};

} // namespace parlour::tools
