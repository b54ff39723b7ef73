#include "tools/bench/database/mariadb_server.hpp"

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <utility>

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace parlour::tools {

namespace {

namespace fs = std::filesystem;

// The first descriptor that a service receives by socket activation
// (sd_listen_fds).
constexpr int first_handed_over = 3;

// Opens a listening socket on a free port of 127.0.0.1; `port` stays 0 if that
// fails. Handing an open socket over leaves no moment in which another program
// could take the port.
int listen_anywhere(unsigned& port) {
  const int listener = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t length = sizeof address;
  auto* place = reinterpret_cast<sockaddr*>(&address);
  if (bind(listener, place, length) != 0 || listen(listener, 64) != 0 ||
      getsockname(listener, place, &length) != 0)
    return listener;
  port = ntohs(address.sin_port);
  return listener;
}

// Reads the server's log until it accepts connections. The error has all it has
// said.
Expected<void> wait_until_ready(int log) {
  std::string said;
  char bytes[4096];
  while (said.find("ready for connections") == std::string::npos) {
    const auto count = read(log, bytes, sizeof bytes);
    if (count <= 0)
      return fail(ErrorKind::offline, "mariadbd does not start: " + said);
    said.append(bytes, static_cast<std::size_t>(count));
  }
  return {};
}

// The statements that create the tables of users.
void write_statements(const fs::path& file) {
  std::ofstream all(file);
  all << "create database mysql;\nuse mysql;\n";
  for (const auto* name :
       {"mysql_system_tables.sql", "mysql_system_tables_data.sql"})
    all << std::ifstream(fs::path("/usr/share/mysql") / name).rdbuf();
}

} // namespace

fs::path MariaDBServer::program() {
  for (const auto* place : {"/usr/sbin/mariadbd", "/usr/libexec/mariadbd",
                            "/usr/bin/mariadbd", "/usr/sbin/mysqld"})
    if (fs::exists(place))
      return place;
  return {};
}

MariaDBServer::MariaDBServer(fs::path folder, MariaDBServerOptions options)
    : folder_(std::move(folder)), options_(std::move(options)) {
  if (options_.on_port)
    listener_ = listen_anywhere(port_);
}

MariaDBServer::~MariaDBServer() {
  kill();
  if (listener_ >= 0)
    close(listener_);
}

std::string MariaDBServer::socket() const {
  return (folder_ / "socket").string();
}

Expected<void> MariaDBServer::start() {
  if (process_ > 0)
    return {};
  if (program().empty())
    return fail(ErrorKind::offline,
                "there is no mariadbd; install mariadb-server-core");
  const bool is_new = fs::create_directories(folder_ / "data");
  if (is_new && options_.has_users)
    if (auto made = make_users(); !made)
      return made;
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0)
    return fail(ErrorKind::offline, "no pipe can be made");
  launch(arguments(), STDIN_FILENO, ends[1]);
  close(ends[1]);
  // The log is only read until then. Later the server writes it to a closed
  // pipe.
  auto ready = wait_until_ready(ends[0]);
  close(ends[0]);
  if (!ready)
    kill();
  return ready;
}

// Does what mariadb-install-db does, as far as it is needed here.
Expected<void> MariaDBServer::make_users() {
  const auto file = folder_ / "users.sql";
  write_statements(file);
  const int input = open(file.c_str(), O_RDONLY | O_CLOEXEC);
  const int output = open("/dev/null", O_WRONLY | O_CLOEXEC);
  auto all = arguments();
  all.emplace_back("--bootstrap");
  launch(all, input, output);
  close(input);
  close(output);
  int status = 0;
  waitpid(std::exchange(process_, -1), &status, 0);
  if (status != 0)
    return fail(ErrorKind::offline, "mariadbd makes no tables of users");
  return {};
}

// Small buffers and no safeguards against a loss of power make it start within
// a second.
std::vector<std::string> MariaDBServer::arguments() const {
  std::vector<std::string> all{"--no-defaults",
                               "--user=root",
                               "--datadir=" + (folder_ / "data").string(),
                               "--socket=" + socket(),
                               "--pid-file=" + (folder_ / "pid").string(),
                               "--innodb-buffer-pool-size=8M",
                               "--innodb-log-file-size=4M",
                               "--innodb-flush-log-at-trx-commit=2",
                               "--innodb-use-native-aio=0",
                               "--innodb-doublewrite=0",
                               "--performance-schema=OFF",
                               "--key-buffer-size=1M",
                               "--skip-name-resolve",
                               "--character-set-server=latin1"};
  if (!options_.has_users)
    all.emplace_back("--skip-grant-tables");
  if (listener_ < 0)
    all.emplace_back("--skip-networking");
  all.insert(all.end(), options_.arguments.begin(), options_.arguments.end());
  return all;
}

void MariaDBServer::launch(const std::vector<std::string>& arguments, int input,
                           int output) {
  process_ = fork();
  if (process_ == 0)
    become(arguments, input, output);
}

// In the child: connects input and output, passes the listening socket on, and
// runs the program. PR_SET_PDEATHSIG ends it with the thread that started it.
void MariaDBServer::become(const std::vector<std::string>& arguments, int input,
                           int output) const {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  dup2(input, STDIN_FILENO);
  dup2(output, STDOUT_FILENO);
  dup2(output, STDERR_FILENO);
  // Sockets are closed on exec by default; this one must stay open.
  if (listener_ == first_handed_over)
    fcntl(listener_, F_SETFD, 0);
  else if (listener_ >= 0)
    dup2(listener_, first_handed_over);
  if (listener_ >= 0) {
    // The protocol of socket activation (sd_listen_fds).
    setenv("LISTEN_FDS", "1", 1);
    setenv("LISTEN_PID", std::to_string(getpid()).c_str(), 1);
  }
  const auto name = program().string();
  std::vector<char*> words{const_cast<char*>(name.c_str())};
  for (const auto& argument : arguments)
    words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  execv(name.c_str(), words.data());
  _exit(127);
}

void MariaDBServer::kill() {
  end(SIGKILL);
}

void MariaDBServer::stop() {
  end(SIGTERM);
}

// A stop takes effect on all threads of the server a moment later; waitpid
// returns then.
void MariaDBServer::pause() {
  if (process_ <= 0)
    return;
  ::kill(process_, SIGSTOP);
  ::waitpid(process_, nullptr, WUNTRACED);
}

void MariaDBServer::go_on() {
  if (process_ > 0)
    ::kill(process_, SIGCONT);
}

// Sends the signal and waits until the process has ended.
void MariaDBServer::end(int signal) {
  if (process_ <= 0)
    return;
  ::kill(process_, signal);
  int status = 0;
  waitpid(std::exchange(process_, -1), &status, 0);
}

} // namespace parlour::tools
