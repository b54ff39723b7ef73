// A MariaDB server of the test program's own: in a temporary folder, on a
// socket, without a network, ended with the program. Where the machine has
// none, is_there() is false, and tests that need one are skipped.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/support/temporary_folder.hpp"

namespace parlour::test {

class MariaDBServer {
public:
  // Started with the first that asks.
  static MariaDBServer& shared() {
    static MariaDBServer server;
    return server;
  }

  MariaDBServer() {
    for (const auto* program : {"/usr/sbin/mariadbd", "/usr/libexec/mariadbd",
                                "/usr/sbin/mysqld", "/usr/bin/mariadbd"})
      if (program_.empty() && std::filesystem::exists(program))
        program_ = program;
    if (is_there())
      start();
  }
  MariaDBServer(const MariaDBServer&) = delete;
  MariaDBServer& operator=(const MariaDBServer&) = delete;
  ~MariaDBServer() {
    kill();
  }

  bool is_there() const {
    return !program_.empty();
  }
  std::string socket() const {
    return (folder_.path() / "socket").string();
  }

  // Waits until it takes connections.
  void start() {
    if (process_ > 0)
      return;
    std::filesystem::create_directories(folder_.path() / "data");
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0)
      throw std::runtime_error("no pipe can be made");
    process_ = fork();
    if (process_ == 0)
      run(ends[1]);
    ::close(ends[1]);
    wait_until_ready(ends[0]);
    ::close(ends[0]);
  }

  // As if the power had failed.
  void kill() {
    end(SIGKILL);
  }
  // In order; a statement that runs is ended.
  void stop() {
    end(SIGTERM);
  }
  // It is there but does not answer.
  void pause() {
    ::kill(process_, SIGSTOP);
  }
  void go_on() {
    ::kill(process_, SIGCONT);
  }

private:
  // In the new process; the server writes its log into the pipe.
  [[noreturn]] void run(int log) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    dup2(log, STDOUT_FILENO);
    dup2(log, STDERR_FILENO);
    const auto data = "--datadir=" + (folder_.path() / "data").string();
    const auto where = "--socket=" + socket();
    const auto id = "--pid-file=" + (folder_.path() / "pid").string();
    execl(program_.c_str(), "mariadbd", "--no-defaults", "--user=root",
          data.c_str(), where.c_str(), id.c_str(), "--skip-networking",
          "--skip-grant-tables", "--innodb-buffer-pool-size=8M",
          "--innodb-log-file-size=4M", "--innodb-flush-log-at-trx-commit=2",
          "--innodb-use-native-aio=0", "--innodb-doublewrite=0",
          "--performance-schema=OFF", "--key-buffer-size=1M",
          "--character-set-server=latin1", nullptr);
    _exit(127);
  }

  // Its log says so. Read to its end, the log would keep us for ever: so only
  // until then, and a server that ends closes it.
  void wait_until_ready(int log) {
    std::string said;
    char bytes[4096];
    ssize_t count = 0;
    while (said.find("ready for connections") == std::string::npos &&
           (count = read(log, bytes, sizeof bytes)) > 0)
      said.append(bytes, static_cast<std::size_t>(count));
    if (count <= 0) {
      kill();
      throw std::runtime_error("mariadbd does not start: " + said);
    }
  }

  void end(int signal) {
    if (process_ <= 0)
      return;
    ::kill(process_, signal);
    int status = 0;
    waitpid(process_, &status, 0);
    process_ = -1;
  }

  TemporaryFolder folder_;
  std::string program_;
  pid_t process_ = -1;
};

} // namespace parlour::test
