#include "tools/bench/agents/connected_agents.hpp"

#include <atomic>
#include <chrono>
#include <fstream>
#include <optional>
#include <ostream>
#include <string>
#include <thread>
#include <vector>

#include <asio.hpp>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <zmq.hpp>
#include <zmq_addon.hpp>

#include "adapters/agents/wire/multipart.hpp"
#include "adapters/agents/wire/text_line.hpp"
#include "tools/bench/agents/bench_agent.hpp"
#include "tools/bench/agents/exchange.hpp"

namespace parlour::tools {

namespace {

using namespace adapters::agents;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;
using asio::ip::tcp;

constexpr auto patience = 60s;
constexpr auto beat_every = 500ms;
// That each agent sends once it is connected.
constexpr std::size_t messages = 10;

// Each connection has a descriptor.
void allow_many_files() {
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) == 0) {
    limit.rlim_cur = limit.rlim_max;
    setrlimit(RLIMIT_NOFILE, &limit);
  }
}

// The memory that this process really has, in bytes.
double resident() {
  std::ifstream file("/proc/self/statm");
  double all = 0;
  double resident = 0;
  file >> all >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

// -- the agents' process ------------------------------------------------------

AgentMessage hello_of(std::size_t number) {
  AgentMessage hello;
  hello.kind = MessageKind::hello;
  hello.component = bench_agent_name(number);
  hello.command = "Hello";
  hello.parameters = {fmt::format("incarnation={:016x}", number + 1)};
  return hello;
}

AgentMessage numbered(std::size_t number) {
  AgentMessage message;
  message.command = "Seen";
  message.number = number;
  message.parameters.emplace_back(exchanged_bytes, 'x');
  return message;
}

AgentMessage beat() {
  AgentMessage message;
  message.kind = MessageKind::beat;
  return message;
}

// All agents on one thread. They need not read what the platform says: it is
// little.
class Crowd {
public:
  virtual ~Crowd() = default;
  virtual void add() = 0;
  virtual void say(std::size_t agent, const AgentMessage& message) = 0;
};

class LineCrowd : public Crowd {
public:
  explicit LineCrowd(std::uint16_t port)
      : end_(asio::ip::address_v4::loopback(), port) {}
  void add() override {
    sockets_.emplace_back(context_);
    sockets_.back().connect(end_);
  }
  void say(std::size_t agent, const AgentMessage& message) override {
    asio::write(sockets_.at(agent), asio::buffer(line_of(message).value()));
  }

private:
  asio::io_context context_;
  tcp::endpoint end_;
  std::vector<tcp::socket> sockets_;
};

class FrameCrowd : public Crowd {
public:
  explicit FrameCrowd(std::uint16_t port)
      : address_(fmt::format("tcp://127.0.0.1:{}", port)) {
    context_.set(zmq::ctxopt::max_sockets, 10'000);
  }
  void add() override {
    sockets_.emplace_back(context_, zmq::socket_type::dealer);
    sockets_.back().set(zmq::sockopt::linger, 0);
    sockets_.back().connect(address_);
  }
  void say(std::size_t agent, const AgentMessage& message) override {
    const auto frames = frames_of(message).value();
    std::vector<zmq::const_buffer> parts;
    for (const auto& frame : frames)
      parts.push_back(zmq::buffer(frame));
    zmq::send_multipart(sockets_.at(agent), parts);
  }

private:
  zmq::context_t context_;
  const std::string address_;
  std::vector<zmq::socket_t> sockets_;
};

// Until the other process has closed the pipe.
void play(Crowd& crowd, std::size_t agents, int pipe) {
  for (std::size_t i = 0; i < agents; ++i) {
    crowd.add();
    crowd.say(i, hello_of(i));
    for (std::size_t number = 1; number <= messages; ++number)
      crowd.say(i, numbered(number));
  }
  pollfd over{pipe, POLLIN, 0};
  while (poll(&over, 1, static_cast<int>(beat_every / 1ms)) == 0)
    for (std::size_t i = 0; i < agents; ++i)
      crowd.say(i, beat());
}

// Reads the port from the pipe.
[[noreturn]] void run_crowd(AgentTransport transport, std::size_t agents,
                            int pipe) {
  std::uint16_t port = 0;
  if (read(pipe, &port, sizeof port) == sizeof port)
    try {
      if (transport == AgentTransport::lines) {
        LineCrowd crowd(port);
        play(crowd, agents, pipe);
      } else {
        FrameCrowd crowd(port);
        play(crowd, agents, pipe);
      }
    } catch (const std::exception&) {
      _exit(1); // the platform has gone, or does not take so many
    }
  _exit(0);
}

// The process of all agents. It ends with this object.
class CrowdProcess {
public:
  CrowdProcess(AgentTransport transport, std::size_t agents) {
    int ends[2] = {-1, -1};
    if (pipe(ends) != 0)
      return;
    write_ = ends[1];
    process_ = fork();
    if (process_ == 0) {
      close(ends[1]);
      run_crowd(transport, agents, ends[0]);
    }
    close(ends[0]);
  }
  CrowdProcess(const CrowdProcess&) = delete;
  CrowdProcess& operator=(const CrowdProcess&) = delete;
  ~CrowdProcess() {
    close(write_);
    if (process_ > 0)
      waitpid(process_, nullptr, 0);
  }

  void connect_to(std::uint16_t port) const {
    if (write(write_, &port, sizeof port) != sizeof port)
      return; // it has not started: nobody will connect
  }

private:
  int write_ = -1;
  pid_t process_ = -1;
};

// -- the platform -------------------------------------------------------------

// The component of each agent.
class Doorman : public AgentServer::Component {
public:
  void online(const Hello&) override {
    ++online_;
  }
  void offline() override {
    --online_;
  }
  std::optional<WireError> received(AgentMessage) override {
    ++received_;
    return {};
  }
  void refused(const AgentMessage&, const Error&) override {}
  void failed(const std::string&) noexcept override {}

  std::size_t online() const {
    return online_;
  }
  std::size_t received() const {
    return received_;
  }

private:
  std::atomic<std::size_t> online_ = 0;
  std::atomic<std::size_t> received_ = 0;
};

std::uint16_t port_of(const AgentServer& server) {
  const auto text = server.addresses().front();
  return static_cast<std::uint16_t>(
      std::stoi(text.substr(text.rfind(':') + 1)));
}

bool wait_for_all(const Doorman& doorman, std::size_t agents) {
  const auto end = Clock::now() + patience;
  while (doorman.online() < agents || doorman.received() < agents * messages) {
    if (Clock::now() > end)
      return false;
    std::this_thread::sleep_for(10ms);
  }
  return true;
}

bool measure(AgentTransport transport, std::size_t agents, std::ostream& out) {
  const CrowdProcess crowd(transport, agents);
  const auto before = resident();
  auto server = start_bench_server(transport, agents);
  if (!server) {
    out << "connected " << server.error().message << '\n';
    return false;
  }
  const auto doorman = std::make_shared<Doorman>();
  for (std::size_t i = 0; i < agents; ++i)
    (*server)->attach(bench_agent_name(i), doorman);
  const auto start = Clock::now();
  crowd.connect_to(port_of(**server));
  const bool all = wait_for_all(*doorman, agents);
  const std::chrono::duration<double> passed = Clock::now() - start;
  // They stay connected while they only beat.
  std::this_thread::sleep_for(4s);
  out << fmt::format(
      "connected by {}: {} of {} agents within {:.1f} s, {} of {} messages; "
      "{:.1f} KiB of resident memory for each, with its account; still there "
      "after 4 s: {}\n",
      name_of(transport), all ? agents : doorman->online(), agents,
      passed.count(), doorman->received(), agents * messages,
      (resident() - before) / 1024 / static_cast<double>(agents),
      doorman->online());
  return all;
}

} // namespace

bool connected_row(const BenchRows& wanted, std::ostream& out) {
  allow_many_files();
  const auto agents = static_cast<std::size_t>(wanted.agents);
  return measure(AgentTransport::lines, agents, out) &&
         measure(AgentTransport::zeromq, agents, out);
}

} // namespace parlour::tools
