#include "tools/bench/agents/bench_agent.hpp"

#include <chrono>
#include <future>
#include <optional>
#include <utility>

namespace parlour::tools {

using namespace adapters::agents;

namespace {

constexpr std::chrono::seconds patience{10};

// The platform's side.
class Desk : public AgentServer::Component {
public:
  explicit Desk(BenchAgent::Take take) : take_(std::move(take)) {}

  void online(const Hello&) override {
    if (!std::exchange(was_online_, true))
      is_online_.set_value();
  }
  void offline() override {}
  std::optional<WireError> received(AgentMessage message) override {
    take_(std::move(message));
    return {};
  }
  void refused(const AgentMessage&, const Error& error) override {
    trouble_ = error.message;
  }
  void failed(const std::string& reason) noexcept override {
    trouble_ = reason;
  }

  bool wait_until_online() {
    return is_online_.get_future().wait_for(patience) ==
           std::future_status::ready;
  }
  const std::string& trouble() const {
    return trouble_;
  }

private:
  const BenchAgent::Take take_;
  bool was_online_ = false;
  std::promise<void> is_online_;
  std::string trouble_;
};

// The agent's side.
class Ear : public AgentConnection::Listener {
public:
  explicit Ear(BenchAgent::Take take) : take_(std::move(take)) {}

  void received(AgentMessage message) override {
    connection->handed_on();
    if (take_)
      take_(std::move(message));
  }
  void note(const std::string&) override {}
  void offline() override {}
  void rejected(const Error&) override {}

  AgentConnection* connection = nullptr;

private:
  const BenchAgent::Take take_;
};

} // namespace

// The connection ends before those that it tells.
struct BenchAgent::Sides {
  Sides(AgentServer& its_server, std::string its_name, Take platform,
        Take agent)
      : server(its_server), name(std::move(its_name)),
        desk(std::make_shared<Desk>(std::move(platform))),
        ear(std::move(agent)) {
    server.attach(name, desk);
  }
  Sides(const Sides&) = delete;
  Sides& operator=(const Sides&) = delete;
  ~Sides() {
    connection.reset();
    server.detach(name, desk.get());
  }

  AgentServer& server;
  const std::string name;
  const std::shared_ptr<Desk> desk;
  Ear ear;
  std::unique_ptr<AgentConnection> connection;
};

std::string_view name_of(AgentTransport transport) {
  return transport == AgentTransport::lines ? "lines" : "zeromq";
}

std::string bench_agent_name(std::size_t number) {
  return "Agent" + std::to_string(number);
}

Expected<std::unique_ptr<AgentServer>>
start_bench_server(AgentTransport transport, std::size_t agents) {
  ServerOptions options;
  for (std::size_t i = 0; i < agents; ++i)
    options.accounts.push_back({bench_agent_name(i), "", ""});
  if (transport == AgentTransport::lines)
    options.lines.emplace();
  else
    options.zeromq.emplace();
  return AgentServer::start(std::move(options));
}

PlatformAddress bench_address(const AgentServer& server,
                              AgentTransport transport) {
  const auto text = server.addresses().front();
  PlatformAddress address;
  address.host = "127.0.0.1";
  address.port = text.substr(text.rfind(':') + 1);
  address.is_zeromq = transport == AgentTransport::zeromq;
  return address;
}

Expected<BenchAgent> BenchAgent::connect(AgentServer& server,
                                         AgentTransport transport,
                                         const std::string& name, Take platform,
                                         Take agent) {
  auto sides = std::make_unique<Sides>(server, name, std::move(platform),
                                       std::move(agent));
  Hello hello;
  hello.name = name;
  auto opened = AgentConnection::open(bench_address(server, transport), hello,
                                      sides->ear);
  if (!opened)
    return tl::make_unexpected(std::move(opened.error()));
  sides->connection = std::move(*opened);
  sides->ear.connection = sides->connection.get();
  if (!sides->desk->wait_until_online())
    return fail(ErrorKind::timeout, name + " is not connected");
  return BenchAgent(std::move(sides));
}

BenchAgent::BenchAgent(std::unique_ptr<Sides> sides)
    : sides_(std::move(sides)) {}
BenchAgent::BenchAgent(BenchAgent&&) noexcept = default;
BenchAgent& BenchAgent::operator=(BenchAgent&&) noexcept = default;
BenchAgent::~BenchAgent() = default;

AgentConnection& BenchAgent::connection() {
  return *sides_->connection;
}

const std::string& BenchAgent::trouble() const {
  return sides_->desk->trouble();
}

} // namespace parlour::tools
