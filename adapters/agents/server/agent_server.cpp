#include "adapters/agents/server/agent_server.hpp"

#include <atomic>
#include <chrono>
#include <exception>
#include <future>
#include <map>
#include <mutex>
#include <thread>
#include <utility>

#include "adapters/agents/delivery/steady_time.hpp"
#include "adapters/agents/delivery/transport.hpp"
#include "adapters/agents/server/mistake_log.hpp"
#include "adapters/agents/zeromq/zeromq_listener.hpp"
#include "adapters/loop/alarm.hpp"

namespace parlour::adapters::agents {
namespace {

// Half of the time after which an acknowledgement is due, so that it is never
// much too late.
constexpr Milliseconds tick_every{50};
constexpr Milliseconds leave_within{500};

// A message on its way from another thread to the exchange.
struct Sent {
  std::string agent;
  AgentMessage message;
};

} // namespace

// Everything belongs to the loop's thread but the queue of messages to be sent,
// which has a mutex. Components are called without one.
class AgentServer::Implementation : public AgentExchange::Connections,
                                    public AgentExchange::Platform,
                                    public TransportEvents {
public:
  Implementation(const ServerOptions& options, std::unique_ptr<Loop> loop)
      : loop_(std::move(loop)),
        exchange_(options.accounts, new_incarnation(), *this, *this),
        mistakes_(options.log), alarm_(*loop_, [this] { tick(); }) {}
  // The transports are closed on their own thread. What was written before the
  // end still leaves.
  ~Implementation() override {
    loop_->post([this] {
      for (const auto& transport : transports_)
        transport->shut();
      alarm_.set(Alarm::never);
    });
    loop_->stop(leave_within);
  }

  void threw(const std::string& what) {
    fail_all(what);
    // What an arrival has left.
    loop_->post([this] { send_queued(steady_now()); });
  }

  // On the loop's thread as well: agents may connect at once.
  Expected<void> listen(const ServerOptions& options) {
    std::promise<Expected<void>> listening;
    loop_->post([&] { listening.set_value(add_transports(options)); });
    return listening.get_future().get();
  }

  std::vector<std::string> addresses() const {
    std::vector<std::string> all;
    for (const auto& transport : transports_)
      all.push_back(transport->address());
    return all;
  }

  // -- from any thread --------------------------------------------------------

  std::map<std::string, std::uint64_t> mistakes() const {
    return mistakes_.counts();
  }

  void attach(const std::string& agent, std::shared_ptr<Component> component) {
    loop_->post([this, agent, attached = std::move(component)] {
      auto& entry = components_[agent];
      entry.component = attached;
      if (entry.hello)
        tell(agent, [&](Component& one) { one.online(*entry.hello); });
    });
  }

  // What is posted runs after a call into the component that is under way.
  void detach(const std::string& agent, const Component* component) {
    std::promise<void> detached;
    loop_->post([&] {
      auto& entry = components_[agent];
      if (entry.component.get() == component)
        entry.component.reset();
      detached.set_value();
    });
    detached.get_future().wait();
  }

  // Wakes the thread only for the first message: it takes all that have
  // collected. A component that answers at once need not wake it.
  void send(const std::string& agent, AgentMessage message) {
    std::lock_guard lock(queue_mutex_);
    queue_.push_back({agent, std::move(message)});
    is_queue_empty_.store(false, std::memory_order_relaxed);
    if (queue_.size() == 1 && !is_in_arrival())
      loop_->post([this] { send_queued(steady_now()); });
  }

  // -- the transports ---------------------------------------------------------

  ConnectionId next_id() override {
    return ++last_id_;
  }
  void opened(ConnectionId id, Peer peer) override {
    exchange_.opened(id, std::move(peer), steady_now());
    plan();
  }
  void heard(ConnectionId id) override {
    heard_ = steady_now();
    exchange_.heard(id, heard_);
  }
  void arrived(ConnectionId id, Read<AgentMessage>&& message) override {
    {
      const Arrival arrival(*this);
      exchange_.arrived(id, std::move(message), heard_);
    }
    // What others have queued meanwhile has been posted as well.
    if (!is_queue_empty_.load(std::memory_order_relaxed))
      send_queued(heard_);
    plan();
  }
  void closed(ConnectionId id) override {
    exchange_.closed(id);
    plan(); // its agent has some time to return
  }
  void turned_away(const std::string& peer, const WireError& error) override {
    mistakes_.note(peer, error, steady_now());
  }
  void not_accepted(const std::string& reason) override {
    mistakes_.note_not_accepted(reason, steady_now());
  }
  void write(ConnectionId id, const AgentMessage& message) override {
    if (auto* transport = transport_of(id))
      transport->write(id, message);
  }
  void pack(ConnectionId id) override {
    if (auto* transport = transport_of(id))
      transport->pack(id);
  }
  void close(ConnectionId id) override {
    if (auto* transport = transport_of(id))
      transport->close(id);
  }

  // -- the components ---------------------------------------------------------

  void online(const Hello& hello) override {
    components_[hello.name].hello = hello;
    tell(hello.name, [&](Component& component) { component.online(hello); });
  }
  void offline(const std::string& agent) override {
    components_[agent].hello.reset();
    tell(agent, [](Component& component) { component.offline(); });
  }
  std::optional<WireError> received(const std::string& agent,
                                    AgentMessage&& message) override {
    const auto command = message.command;
    std::optional<WireError> error;
    if (!tell(agent, [&](Component& component) {
          error = component.received(std::move(message));
        }))
      return WireError{WireErrorKind::refused,
                       "nobody takes '" + excerpt(command) + "' at present"};
    return error;
  }
  void refused(const std::string& agent, const AgentMessage& message,
               const Error& error) override {
    AgentMessage kept;
    kept.session = message.session;
    kept.correlation = message.correlation;
    kept.command = message.command;
    tell(agent, [&](Component& component) { component.refused(kept, error); });
  }
  void mistake(const std::string& peer, const WireError& error) override {
    mistakes_.note(peer, error, steady_now());
  }

private:
  struct Entry {
    // Null: none is attached.
    std::shared_ptr<Component> component;
    // Set while the agent is online.
    std::optional<Hello> hello;
  };

  Expected<void> add_transports(const ServerOptions& options) {
    if (options.lines)
      if (auto added = add(listen_for_lines(*loop_, *this, *options.lines));
          !added)
        return added;
    if (options.zeromq)
      if (auto added = add(listen_by_zeromq(*loop_, *this,
                                            {options.zeromq->address,
                                             options.zeromq->secret_key,
                                             options.zeromq->allowed_keys}));
          !added)
        return added;
    return check_accounts(options.accounts);
  }

  Expected<void> add(Expected<std::unique_ptr<AgentTransport>> transport) {
    if (!transport)
      return tl::make_unexpected(std::move(transport.error()));
    transports_.push_back(std::move(*transport));
    return {};
  }

  // Off loopback nobody may come without a token or a key.
  Expected<void>
  check_accounts(const std::vector<AgentAccount>& accounts) const {
    for (const auto& transport : transports_)
      for (const auto& account : accounts)
        if (!transport->is_loopback() && account.token.empty() &&
            account.public_key.empty())
          return fail(ErrorKind::settings,
                      transport->address() +
                          " can be reached from other hosts: give the agent " +
                          account.name + " a token or a key");
    return {};
  }

  AgentTransport* transport_of(ConnectionId id) {
    for (const auto& transport : transports_)
      if (transport->has(id))
        return transport.get();
    return nullptr;
  }

  // False: the agent has no component, or it has thrown.
  template <class Action>
  bool tell(const std::string& agent, Action&& action) {
    const auto found = components_.find(agent);
    if (found == components_.end() || !found->second.component)
      return false;
    try {
      // Who is attached or detached meanwhile comes and goes in a later turn.
      action(*found->second.component);
      return true;
    } catch (const std::exception& exception) {
      fail_component(found->second, exception.what());
    } catch (...) {
      fail_component(found->second, "an exception of an unknown type");
    }
    return false;
  }

  static void fail_component(Entry& entry, const std::string& reason) {
    if (const auto component = std::exchange(entry.component, {}))
      component->failed(reason);
  }

  // A transport or the exchange has thrown, so that nobody knows which messages
  // were lost: that is a failure of every component.
  void fail_all(const std::string& reason) {
    for (auto& [agent, entry] : components_)
      fail_component(entry, reason);
  }

  // While it lives, the server's thread deals with a message that has arrived,
  // and will look at the queue then.
  class Arrival {
  public:
    explicit Arrival(Implementation& server) : server_(server) {
      server_.arrival_thread_.store(std::this_thread::get_id(),
                                    std::memory_order_relaxed);
    }
    Arrival(const Arrival&) = delete;
    Arrival& operator=(const Arrival&) = delete;
    ~Arrival() {
      server_.arrival_thread_.store({}, std::memory_order_relaxed);
    }

  private:
    Implementation& server_;
  };
  // Only the thread itself can find its own id there.
  bool is_in_arrival() const {
    return arrival_thread_.load(std::memory_order_relaxed) ==
           std::this_thread::get_id();
  }

  void send_queued(Timestamp now) {
    leaving_.clear();
    if (leaving_.capacity() > Link::max_waiting)
      leaving_.shrink_to_fit();
    {
      std::lock_guard lock(queue_mutex_);
      std::swap(queue_, leaving_);
      is_queue_empty_.store(true, std::memory_order_relaxed);
    }
    // A message that is not sent is left as it was.
    for (auto& [agent, message] : leaving_)
      if (auto done = exchange_.send(agent, std::move(message), now); !done)
        // NOLINTNEXTLINE(bugprone-use-after-move)
        refused(agent, message, done.error());
    plan();
  }

  // Keeps the alarm ringing for heartbeats and acknowledgements, as long as
  // anybody is connected.
  void plan() {
    if (!std::exchange(planned_, true))
      alarm_.set(Alarm::Moment::clock::now() + tick_every);
  }
  void tick() {
    planned_ = false;
    exchange_.tick(steady_now());
    if (exchange_.next_tick())
      plan();
  }

  // The first member, destroyed last: the transports use it.
  const std::unique_ptr<Loop> loop_;
  AgentExchange exchange_;
  MistakeLog mistakes_;
  std::vector<std::unique_ptr<AgentTransport>> transports_;
  Alarm alarm_;
  bool planned_ = false;
  ConnectionId last_id_ = 0;
  std::map<std::string, Entry> components_;

  // The time of what is being read.
  Timestamp heard_ = 0;
  std::atomic<std::thread::id> arrival_thread_{};

  // Written with the mutex, read by the loop's thread without.
  std::atomic<bool> is_queue_empty_ = true;
  std::mutex queue_mutex_;
  std::vector<Sent> queue_;
  // Taken from the queue; for its memory.
  std::vector<Sent> leaving_;
};

Expected<std::unique_ptr<AgentServer>>
AgentServer::start(ServerOptions options) {
  const auto owner = std::make_shared<Implementation*>();
  auto loop =
      Loop::start([owner](const std::string& what) { (*owner)->threw(what); });
  if (!loop)
    return tl::make_unexpected(std::move(loop.error()));
  auto implementation =
      std::make_unique<Implementation>(options, std::move(*loop));
  *owner = implementation.get();
  if (auto listening = implementation->listen(options); !listening)
    return tl::make_unexpected(std::move(listening.error()));
  return std::unique_ptr<AgentServer>(
      new AgentServer(std::move(implementation)));
}

AgentServer::AgentServer(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}

AgentServer::~AgentServer() = default;

std::vector<std::string> AgentServer::addresses() const {
  return implementation_->addresses();
}

std::map<std::string, std::uint64_t> AgentServer::mistakes() const {
  return implementation_->mistakes();
}

void AgentServer::attach(const std::string& agent,
                         std::shared_ptr<Component> component) {
  implementation_->attach(agent, std::move(component));
}

void AgentServer::detach(const std::string& agent, const Component* component) {
  implementation_->detach(agent, component);
}

void AgentServer::send(const std::string& agent, AgentMessage message) {
  implementation_->send(agent, std::move(message));
}

} // namespace parlour::adapters::agents
