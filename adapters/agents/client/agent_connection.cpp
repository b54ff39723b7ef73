#include "adapters/agents/client/agent_connection.hpp"

#include <atomic>
#include <chrono>
#include <optional>
#include <thread>
#include <utility>

#include "adapters/agents/client/platform_talk.hpp"
#include "adapters/agents/client/reconnection.hpp"
#include "adapters/agents/client/shared_link.hpp"
#include "adapters/agents/delivery/steady_time.hpp"
#include "adapters/loop/alarm.hpp"

namespace parlour::adapters::agents {

namespace {

using namespace std::chrono_literals;

constexpr std::chrono::milliseconds tick_every = 50ms;
constexpr std::chrono::milliseconds leave_within = 1s;

} // namespace

// Everything belongs to the loop's thread but the link.
class AgentConnection::Implementation : private PeerConnection::Owner,
                                        private PlatformTalk::Owner {
public:
  Implementation(const PlatformAddress& address, Hello hello,
                 Listener& listener, std::unique_ptr<Loop> loop,
                 std::unique_ptr<PlatformDialler> dialler)
      : address_(address.host + ":" + address.port),
        is_zeromq_(address.is_zeromq), listener_(listener),
        loop_(std::move(loop)), link_(new_incarnation()),
        talk_(std::move(hello), link_, *this),
        reconnection_(
            *loop_, std::move(dialler), address_, [this] { connect(); },
            [this](const std::string& text) { listener_.note(text); }),
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

  bool may_connect() const {
    return is_present_ && !leaves_at_;
  }

  void connect() {
    if (!may_connect() || connection_)
      return;
    reconnection_.dial(*this, [this](auto connection) {
      if (!connection)
        return try_later(connection.error().message);
      if (!may_connect())
        return;
      connection_ = std::move(*connection);
      connection_->start();
      talk_.say_hello(*connection_, is_zeromq_);
      heard_ = steady_now();
    });
  }

  void try_later(const std::string& reason) {
    if (may_connect())
      reconnection_.try_later(reason);
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

  void arrived(ConnectionId, Read<AgentMessage>&& message) override {
    // Kept, because the message may end it.
    const auto connection = connection_;
    if (!connection)
      return;
    arrival_thread_.store(std::this_thread::get_id(),
                          std::memory_order_relaxed);
    talk_.take(*connection, std::move(message), heard_);
    arrival_thread_.store({}, std::memory_order_relaxed);
    flush(heard_);
  }

  // -- what the platform's messages mean --------------------------------------

  void welcomed() override {
    reconnection_.succeeded();
    listener_.note("connected to " + address_);
  }

  void received(AgentMessage&& message) override {
    listener_.received(std::move(message));
  }

  void note(const std::string& text) override {
    listener_.note(text);
  }

  void lose(const std::string& reason) override {
    link_.disconnect();
    if (auto connection = std::exchange(connection_, nullptr))
      connection->close();
    try_later(reason);
  }

  void end(const Error& reason) override {
    is_present_ = false;
    say_bye();
    listener_.rejected(reason);
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
    reconnection_.stop();
    tick_alarm_.reset();
  }

  const std::string address_;
  const bool is_zeromq_;
  Listener& listener_;
  const std::unique_ptr<Loop> loop_;
  SharedLink link_;
  PlatformTalk talk_;
  Reconnection reconnection_;
  std::optional<Alarm> tick_alarm_;            // nothing once it has left
  std::shared_ptr<PeerConnection> connection_; // null: there is none
  bool is_present_ = true;
  Timestamp heard_ = 0;
  // When it was last connected, or began.
  Timestamp connected_at_ = steady_now();
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
  auto dialler = PlatformDialler::make(**loop, address);
  if (!dialler)
    return tl::make_unexpected(std::move(dialler.error()));
  auto implementation = std::make_unique<Implementation>(
      address, hello, listener, std::move(*loop), std::move(*dialler));
  *owner = implementation.get();
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
