#include "adapters/agents/client/agent_connection.hpp"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "adapters/agents/delivery/steady_time.hpp"
#include "adapters/agents/lines/line_connection.hpp"
#include "adapters/loop/alarm.hpp"

namespace parlour::adapters::agents {

namespace {

using namespace std::chrono_literals;
using asio::ip::tcp;
using SecureStream = asio::ssl::stream<tcp::socket>;

constexpr std::chrono::milliseconds first_pause = 200ms;
constexpr std::chrono::milliseconds longest_pause = 5s;
constexpr std::chrono::milliseconds tick_every = 50ms;
constexpr std::chrono::milliseconds leave_within = 1s;

bool ends_for_good(WireErrorKind kind) {
  using enum WireErrorKind;
  return kind == identity || kind == version || kind == replaced;
}

} // namespace

// Everything belongs to the loop's thread, but for what is sent: it is queued
// under a lock, so that send() can refuse.
class AgentConnection::Implementation : private LineConnection::Owner {
public:
  Implementation(PlatformAddress address, Hello hello, Listener& listener,
                 std::unique_ptr<Loop> loop)
      : address_(std::move(address)), hello_(std::move(hello)),
        listener_(listener), loop_(std::move(loop)), link_(new_incarnation()),
        resolver_(loop_->context()),
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

  Expected<void> prepare() {
    if (!address_.is_encrypted)
      return {};
    tls_.emplace(asio::ssl::context::tls_client);
    asio::error_code error;
    if (address_.authority.empty())
      tls_->set_default_verify_paths(error);
    else
      tls_->load_verify_file(address_.authority, error);
    if (error)
      return fail(ErrorKind::settings, "the certificate '" +
                                           address_.authority +
                                           "': " + error.message());
    tls_->set_verify_mode(asio::ssl::verify_peer);
    return {};
  }

  void run() {
    loop_->post([this] {
      connect();
      tick();
    });
  }

  // -- from any thread --------------------------------------------------------

  bool send(AgentMessage message) {
    std::lock_guard lock(mutex_);
    if (queue_.size() >= Link::max_waiting)
      return false;
    queue_.push_back(std::move(message));
    if (queue_.size() == 1)
      loop_->post([this] { send_queued(); });
    return true;
  }

  void handed_on() {
    loop_->post([this] {
      link_.handed_on();
      flush();
    });
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
    resolver_.async_resolve(
        address_.host, address_.port,
        [this](asio::error_code error,
               const tcp::resolver::results_type& found) {
          if (error)
            return try_later(error.message());
          auto socket = std::make_shared<tcp::socket>(loop_->context());
          asio::async_connect(
              *socket, found,
              [this, socket](asio::error_code failed, const tcp::endpoint&) {
                failed ? try_later(failed.message())
                       : begin(std::move(*socket));
              });
        });
  }

  void begin(tcp::socket socket) {
    is_connecting_ = false;
    if (!may_connect())
      return;
    const auto id = ++last_id_;
    Owner& owner = *this;
    if (tls_) {
      SecureStream stream(std::move(socket), *tls_);
      stream.set_verify_callback(
          asio::ssl::host_name_verification(address_.host));
      connection_ = std::make_shared<LineConnectionOver<SecureStream>>(
          std::move(stream), id, owner, asio::ssl::stream_base::client);
    } else {
      connection_ = std::make_shared<LineConnectionOver<tcp::socket>>(
          std::move(socket), id, owner);
    }
    connection_->start();
    hello_.introduction = link_.introduction();
    connection_->write(hello_message(hello_));
    heard_ = steady_now();
  }

  // One line for each loss, not for each attempt.
  void try_later(const std::string& reason) {
    is_connecting_ = false;
    if (!may_connect())
      return;
    if (!std::exchange(loss_is_noted_, true))
      listener_.note(fmt::format("not connected to {}:{}: {}", address_.host,
                                 address_.port, reason));
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
    link_.heard(heard_);
  }

  void lost(ConnectionId) override {
    connection_.reset();
    lose("the platform has closed the connection");
  }

  // -- what arrives -----------------------------------------------------------

  void arrived(ConnectionId, Read<AgentMessage> message) override {
    if (!message)
      return tell(message.error());
    if (message->kind == MessageKind::welcome)
      take_welcome(*message);
    else if (message->kind == MessageKind::error)
      take_error(*message);
    else if (message->kind == MessageKind::bye)
      lose("the platform has said goodbye");
    else if (link_.is_connected())
      take(std::move(*message));
    flush();
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
      return end("version: " + checked.error().sentence);
    }
    if (link_.is_behind(welcome->introduction)) {
      link_.renew(new_incarnation());
      return lose("the platform knows of messages that were never sent");
    }
    link_.connect(welcome->introduction, steady_now());
    mistakes_ = 0;
    pause_ = first_pause;
    loss_is_noted_ = false;
    listener_.note(
        fmt::format("connected to {}:{}", address_.host, address_.port));
  }

  void take_error(const AgentMessage& message) {
    // It ends a request of the agent, or is about an answer of the agent's.
    if (message.correlation)
      return listener_.received(message);
    const auto sentence =
        message.parameters.empty() ? "" : message.parameters.front();
    const auto kind = error_kind_of(message.command);
    if (kind && ends_for_good(*kind))
      return end(message.command + ": " + sentence);
    listener_.note("the platform says " + message.command + ": " + sentence);
    // The platform does not know this connection, or closes it.
    if (kind == WireErrorKind::unknown ||
        (kind && closes_connection({*kind, {}})))
      lose("the platform refuses what the agent says");
  }

  void end(const std::string& reason) {
    is_present_ = false;
    say_bye();
    listener_.rejected({ErrorKind::refused, reason, {}});
  }

  void take(AgentMessage message) {
    auto arrival = link_.receive(message, steady_now());
    if (arrival.error)
      return tell(*arrival.error);
    mistakes_ = 0;
    if (!arrival.deliver)
      return;
    listener_.received(std::move(message));
  }

  // -- what leaves ------------------------------------------------------------

  void send_queued() {
    std::vector<AgentMessage> messages;
    {
      std::lock_guard lock(mutex_);
      messages = std::exchange(queue_, {});
    }
    for (auto& message : messages) {
      const auto command = message.command;
      if (auto checked = check_numbered(message); !checked)
        listener_.note(command + " is not sent: " + checked.error().sentence);
      else if (!link_.send(std::move(message)))
        listener_.note(command + " is not sent: too much waits already");
    }
    flush();
  }

  void flush() {
    if (!connection_)
      return;
    for (const auto& message : link_.take_output(steady_now()))
      connection_->write(message);
    leave_if_done();
  }

  // -- time -------------------------------------------------------------------

  void tick() {
    tick_alarm_->set(std::chrono::steady_clock::now() + tick_every);
    if (connection_ && steady_now() - heard_ >= Link::offline_after.count())
      lose("the platform is silent");
    flush();
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
    resolver_.cancel();
    pause_alarm_.reset();
    tick_alarm_.reset();
  }

  const PlatformAddress address_;
  Hello hello_;
  Listener& listener_;
  const std::unique_ptr<Loop> loop_;
  Link link_;
  std::optional<asio::ssl::context> tls_;
  tcp::resolver resolver_;
  // Nothing once it has left.
  std::optional<Alarm> pause_alarm_;
  std::optional<Alarm> tick_alarm_;
  std::shared_ptr<LineConnection> connection_; // null: there is none
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

  std::mutex mutex_;
  std::vector<AgentMessage> queue_;
};

Expected<std::unique_ptr<AgentConnection>>
AgentConnection::open(const PlatformAddress& address, const Hello& hello,
                      Listener& listener) {
  auto loop = Loop::start();
  if (!loop)
    return tl::make_unexpected(std::move(loop.error()));
  auto implementation = std::make_unique<Implementation>(
      address, hello, listener, std::move(*loop));
  if (auto prepared = implementation->prepare(); !prepared)
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

void AgentConnection::handed_on() {
  implementation_->handed_on();
}

void AgentConnection::set_present(bool is_present) {
  implementation_->set_present(is_present);
}

} // namespace parlour::adapters::agents
