#include "adapters/agents/client/agent_connection.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <optional>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "adapters/agents/client/shared_link.hpp"
#include "adapters/agents/delivery/steady_time.hpp"
#include "adapters/loop/alarm.hpp"

namespace parlour::adapters::agents {

namespace {

using namespace std::chrono_literals;

constexpr std::chrono::milliseconds first_pause = 200ms;
constexpr std::chrono::milliseconds longest_pause = 5s;
constexpr std::chrono::milliseconds tick_every = 50ms;
constexpr std::chrono::milliseconds leave_within = 1s;

bool ends_for_good(WireErrorKind kind) {
  using enum WireErrorKind;
  return kind == identity || kind == version || kind == replaced;
}

} // namespace

// Everything belongs to the loop's thread but the link.
class AgentConnection::Implementation : private PeerConnection::Owner {
public:
  Implementation(const PlatformAddress& address, Hello hello,
                 Listener& listener, std::unique_ptr<Loop> loop)
      : address_(address.host + ":" + address.port),
        is_zeromq_(address.is_zeromq), hello_(std::move(hello)),
        listener_(listener), loop_(std::move(loop)), link_(new_incarnation()),
        pause_alarm_(std::in_place, *loop_, [this] { connect(); }),
        tick_alarm_(std::in_place, *loop_, [this] { tick(); }) {}
  // What was said last is still sent and acknowledged, if that is possible
  // soon.
  ~Implementation() override {
    loop_->post([this] {
      leaves_at_ = steady_now() + leave_within.count();
      leave_if_done();
    });
    loop_->stop(2 * leave_within);
  }

  Expected<void> prepare(PlatformAddress address) {
    auto dialler = PlatformDialler::make(*loop_, std::move(address));
    if (!dialler)
      return tl::make_unexpected(std::move(dialler.error()));
    dialler_ = std::move(*dialler);
    return {};
  }

  void run() {
    loop_->post([this] {
      connect();
      tick();
    });
  }

  // Nobody knows what has been lost. To connect again could lead to the same.
  void threw(const std::string& what) {
    arrival_thread_.store({}, std::memory_order_relaxed);
    end({ErrorKind::thrown, what, {}});
  }

  // -- from any thread --------------------------------------------------------

  bool send(AgentMessage&& message) {
    if (auto checked = check_numbered(message); !checked) {
      note_soon(message.command + " is not sent: " + checked.error().sentence);
      return true;
    }
    if (!link_.send(std::move(message)))
      return false;
    flush_soon();
    return true;
  }

  bool wait_for_room(Milliseconds patience) {
    return link_.wait_for_room(patience);
  }

  // Other acknowledgements may wait for the next tick.
  void handed_on() {
    if (link_.handed_on())
      flush_soon();
  }

  void set_present(bool is_present) {
    loop_->post([this, is_present] {
      const bool before = std::exchange(is_present_, is_present);
      if (before && !is_present)
        say_bye();
      else if (!before && is_present)
        connect();
    });
  }

private:
  // -- the connection ---------------------------------------------------------

  void connect() {
    if (!may_connect() || connection_ || std::exchange(is_connecting_, true))
      return;
    pause_alarm_->set(Alarm::never);
    dialler_->dial(++last_id_, *this, [this](auto connection) {
      is_connecting_ = false;
      if (!connection)
        return try_later(connection.error().message);
      if (!may_connect())
        return;
      connection_ = std::move(*connection);
      say_hello();
    });
  }

  void say_hello() {
    connection_->start();
    hello_.introduction = link_.introduction();
    hello_.introduction.packed = is_zeromq_;
    connection_->write(hello_message(hello_));
    heard_ = steady_now();
  }

  // One line for each loss, not for each attempt.
  void try_later(const std::string& reason) {
    is_connecting_ = false;
    if (!may_connect())
      return;
    if (!std::exchange(loss_is_noted_, true))
      listener_.note(fmt::format("not connected to {}: {}", address_, reason));
    pause_alarm_->set(std::chrono::steady_clock::now() + pause_);
    pause_ = std::min(2 * pause_, longest_pause);
  }

  bool may_connect() const {
    return is_present_ && !leaves_at_;
  }

  void lose(const std::string& reason) {
    link_.disconnect();
    if (auto connection = std::exchange(connection_, nullptr))
      connection->close();
    try_later(reason);
  }

  void say_bye() {
    if (!connection_)
      return;
    AgentMessage bye;
    bye.kind = MessageKind::bye;
    connection_->write(bye);
    link_.disconnect();
    std::exchange(connection_, nullptr)->close();
  }

  void heard(ConnectionId) override {
    heard_ = steady_now();
  }

  void lost(ConnectionId) override {
    connection_.reset();
    lose("the platform has closed the connection");
  }

  // -- what arrives -----------------------------------------------------------

  void arrived(ConnectionId, Read<AgentMessage>&& message) override {
    arrival_thread_.store(std::this_thread::get_id(),
                          std::memory_order_relaxed);
    message ? take(std::move(*message)) : tell(message.error());
    arrival_thread_.store({}, std::memory_order_relaxed);
    flush(heard_);
  }

  void take(AgentMessage&& message) {
    if (message.kind == MessageKind::welcome)
      take_welcome(message);
    else if (message.kind == MessageKind::error)
      take_error(message);
    else if (message.kind == MessageKind::bye)
      lose("the platform has said goodbye");
    else if (link_.is_connected())
      hand_on(std::move(message));
  }

  // A mistake of the platform (adapters/agents/PROTOCOL.md 5). Nobody is told
  // before the welcome.
  void tell(const WireError& error) {
    const auto now = steady_now();
    if (now - std::exchange(noted_, now) >= 1000)
      listener_.note(fmt::format("the platform's message is {}: {}",
                                 name_of(error.kind), error.sentence));
    if (link_.is_connected())
      write_error(error);
    if (++mistakes_ >= AgentExchange::max_malformed || closes_connection(error))
      lose("the platform makes mistakes");
  }

  void write_error(const WireError& error) {
    auto message = error_message(error);
    message.component = hello_.name;
    connection_->write(message);
  }

  void take_welcome(const AgentMessage& message) {
    const auto welcome = welcome_of(message);
    if (!welcome)
      return lose("the platform's welcome: " + welcome.error().sentence);
    if (auto checked = check_version(*welcome, hello_); !checked) {
      write_error(checked.error());
      return end(
          {ErrorKind::refused, "version: " + checked.error().sentence, {}});
    }
    if (link_.is_behind(welcome->introduction)) {
      link_.renew(new_incarnation());
      return lose("the platform knows of messages that were never sent");
    }
    link_.connect(welcome->introduction, steady_now());
    mistakes_ = 0;
    if (welcome->introduction.packed)
      connection_->pack();
    pause_ = first_pause;
    loss_is_noted_ = false;
    listener_.note("connected to " + address_);
  }

  void take_error(const AgentMessage& message) {
    // It ends a request of the agent, or is about an answer of the agent's.
    if (message.correlation)
      return listener_.received(message);
    const auto sentence =
        message.parameters.empty() ? "" : message.parameters.front();
    const auto kind = error_kind_of(message.command);
    if (kind && ends_for_good(*kind))
      return end({ErrorKind::refused, message.command + ": " + sentence, {}});
    listener_.note("the platform says " + message.command + ": " + sentence);
    // The platform does not know this connection, or closes it.
    if (kind == WireErrorKind::unknown ||
        (kind && closes_connection({*kind, {}})))
      lose("the platform refuses what the agent says");
  }

  void end(const Error& reason) {
    is_present_ = false;
    say_bye();
    listener_.rejected(reason);
  }

  void hand_on(AgentMessage&& message) {
    auto arrival = link_.receive(message, heard_);
    if (arrival.error)
      return tell(*arrival.error);
    mistakes_ = 0;
    if (!arrival.deliver)
      return;
    listener_.received(std::move(message));
  }

  // -- what leaves ------------------------------------------------------------

  void note_soon(std::string text) {
    loop_->post([this, text = std::move(text)] { listener_.note(text); });
  }

  // Wakes the thread once for all messages that collect until then. A listener
  // that answers at once need not wake it.
  void flush_soon() {
    if (arrival_thread_.load(std::memory_order_relaxed) ==
            std::this_thread::get_id() ||
        flush_is_posted_ || flush_is_posted_.exchange(true))
      return;
    loop_->post([this] {
      flush_is_posted_ = false;
      flush(steady_now());
    });
  }

  void flush(Timestamp now) {
    if (connection_)
      link_.write_output(now, [this](const AgentMessage& message) {
        connection_->write(message);
      });
    leave_if_done();
  }

  // -- time -------------------------------------------------------------------

  void tick() {
    tick_alarm_->set(std::chrono::steady_clock::now() + tick_every);
    if (connection_ && steady_now() - heard_ >= Link::offline_after.count())
      lose("the platform is silent");
    flush(steady_now());
    tell_if_offline();
    leave_if_done();
  }

  void tell_if_offline() {
    if (link_.is_connected())
      connected_at_ = steady_now();
    else if (steady_now() - connected_at_ >= Link::offline_after.count())
      listener_.offline();
  }

  // Then nothing is waited for, and the loop ends.
  void leave_if_done() {
    const bool waits = connection_ && link_.waiting() > 0;
    if (!leaves_at_ || (waits && steady_now() < *leaves_at_))
      return;
    say_bye();
    if (dialler_)
      dialler_->cancel();
    pause_alarm_.reset();
    tick_alarm_.reset();
  }

  const std::string address_;
  const bool is_zeromq_;
  Hello hello_;
  Listener& listener_;
  const std::unique_ptr<Loop> loop_;
  SharedLink link_;
  std::unique_ptr<PlatformDialler> dialler_;
  // Nothing once it has left.
  std::optional<Alarm> pause_alarm_;
  std::optional<Alarm> tick_alarm_;
  std::shared_ptr<PeerConnection> connection_; // null: there is none
  ConnectionId last_id_ = 0;
  std::chrono::milliseconds pause_ = first_pause;
  bool is_connecting_ = false;
  bool loss_is_noted_ = false;
  bool is_present_ = true;
  Timestamp heard_ = 0;
  // When it was last connected, or began.
  Timestamp connected_at_ = steady_now();
  // The platform's, in a row, and when there last was one.
  int mistakes_ = 0;
  Timestamp noted_ = 0;
  // When it leaves at the latest; nothing: it stays.
  std::optional<Timestamp> leaves_at_;

  // The connection's thread while it deals with a message, and will flush.
  std::atomic<std::thread::id> arrival_thread_{};
  std::atomic<bool> flush_is_posted_ = false;
};

Expected<std::unique_ptr<AgentConnection>>
AgentConnection::open(const PlatformAddress& address, const Hello& hello,
                      Listener& listener) {
  const auto owner = std::make_shared<Implementation*>();
  auto loop =
      Loop::start([owner](const std::string& what) { (*owner)->threw(what); });
  if (!loop)
    return tl::make_unexpected(std::move(loop.error()));
  auto implementation = std::make_unique<Implementation>(
      address, hello, listener, std::move(*loop));
  *owner = implementation.get();
  if (auto prepared = implementation->prepare(address); !prepared)
    return tl::make_unexpected(std::move(prepared.error()));
  implementation->run();
  return std::unique_ptr<AgentConnection>(
      new AgentConnection(std::move(implementation)));
}

AgentConnection::AgentConnection(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}

AgentConnection::~AgentConnection() = default;

bool AgentConnection::send(AgentMessage message) {
  return implementation_->send(std::move(message));
}

bool AgentConnection::wait_for_room(Milliseconds patience) {
  return implementation_->wait_for_room(patience);
}

void AgentConnection::handed_on() {
  implementation_->handed_on();
}

void AgentConnection::set_present(bool is_present) {
  implementation_->set_present(is_present);
}

} // namespace parlour::adapters::agents
