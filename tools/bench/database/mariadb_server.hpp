// A MariaDB server of one's own, for benchmarks and tests: its data lie in a
// folder that is handed over, it listens on a socket there and on no port, and
// it ends with whoever started it. Nobody has to log in.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <sys/types.h>

#include "runtime/base/error.hpp"

namespace parlour::tools {

struct MariaDBServerOptions {
  std::vector<std::string> arguments; // beside those of every such server
  // Listens on a port of this machine that is free, instead of the socket.
  bool on_port = false;
  // Who connects has to be known: root without a password, and whom it makes.
  bool has_users = false;
};

class MariaDBServer {
public:
  // Where this machine has the program; empty: nowhere.
  static std::filesystem::path program();

  explicit MariaDBServer(std::filesystem::path folder,
                         MariaDBServerOptions options = {});
  MariaDBServer(const MariaDBServer&) = delete;
  MariaDBServer& operator=(const MariaDBServer&) = delete;
  ~MariaDBServer();

  // Waits until it takes connections. Nothing happens where it runs. An error
  // of kind Offline has the server's own words in it.
  Expected<void> start();

  void kill();  // as if the power had failed
  void stop();  // in order; a statement that runs is ended
  void pause(); // it is there but does not answer
  void go_on();

  std::string socket() const;
  int process() const { // -1: it does not run
    return process_;
  }
  unsigned port() const { // 0: none
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
  int listener_ = -1; // of the port
  unsigned port_ = 0;
  pid_t process_ = -1;
};

} // namespace parlour::tools
