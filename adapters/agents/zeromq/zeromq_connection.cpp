#include "adapters/agents/zeromq/zeromq_connection.hpp"

#include <iterator>
#include <utility>
#include <vector>

#include <zmq.hpp>
#include <zmq_addon.hpp>

#include "adapters/agents/wire/multipart.hpp"
#include "adapters/agents/zeromq/inflow.hpp"
#include "adapters/agents/zeromq/packed_lines.hpp"

namespace parlour::adapters::agents {
namespace {

// For how long what was said last may take to leave.
constexpr int linger_milliseconds = 500;

class ZeroMQConnection : public PeerConnection,
                         public std::enable_shared_from_this<ZeroMQConnection> {
public:
  ZeroMQConnection(Loop& loop, ConnectionId id, Owner& owner,
                   const ZeroMQPlatform& platform)
      : loop_(loop), id_(id), owner_(&owner),
        dealer_(zeromq_, zmq::socket_type::dealer),
        inflow_(loop, dealer_, [this] { drain(); }) {
    dealer_.set(zmq::sockopt::linger, linger_milliseconds);
    dealer_.set(zmq::sockopt::maxmsgsize,
                static_cast<std::int64_t>(2 * max_message_bytes));
    dealer_.set(zmq::sockopt::ipv6, platform.address.starts_with("tcp://["));
    if (!platform.platform_key.empty()) {
      dealer_.set(zmq::sockopt::curve_serverkey, platform.platform_key);
      dealer_.set(zmq::sockopt::curve_publickey, platform.own.public_key);
      dealer_.set(zmq::sockopt::curve_secretkey, platform.own.secret_key);
    }
    dealer_.connect(platform.address);
  }

  void start() override {
    inflow_.go_on();
  }

  void write(const AgentMessage& message) override {
    if (!packs_)
      return send(message);
    if (!may_be_packed(message)) {
      flush();
      return send(message);
    }
    packed_.add(message);
    if (packed_.is_full())
      packed_.send(dealer_);
    flush_soon();
  }
  void pack() override {
    packs_ = true;
  }

  // The owner may close it while it is told something: it goes in a later turn.
  void close() override {
    owner_ = nullptr;
    flush();
    inflow_.stop();
    loop_.post([self = shared_from_this()] {});
  }

private:
  // How many messages are taken before others have their turn.
  static constexpr int max_at_once = 100;

  // What is written meanwhile leaves together at the end.
  void drain() {
    is_draining_ = true;
    std::vector<zmq::message_t> frames;
    for (int i = 0; i < max_at_once && owner_; ++i) {
      frames.clear();
      if (!zmq::recv_multipart(dealer_, std::back_inserter(frames),
                               zmq::recv_flags::dontwait))
        break;
      take(frames);
      if (is_packed(frames))
        break; // those were many
    }
    is_draining_ = false;
    flush();
  }

  static bool is_packed(const std::vector<zmq::message_t>& frames) {
    return frames.size() == 1;
  }

  void take(const std::vector<zmq::message_t>& frames) {
    owner_->heard(id_);
    if (is_packed(frames))
      return reader_.read(frames.back().to_string_view(),
                          [&](Read<AgentMessage>&& message) {
                            if (owner_) // it may close at any message
                              owner_->arrived(id_, std::move(message));
                          });
    std::vector<std::string_view> fields;
    for (const auto& frame : frames)
      fields.push_back(frame.to_string_view());
    owner_->arrived(id_, read_frames(std::move(fields)));
  }

  // Each field as a frame.
  void send(const AgentMessage& message) {
    const auto frames = frames_of(message);
    if (!frames)
      return; // the link has checked what is to be delivered
    std::vector<zmq::const_buffer> parts;
    for (const auto& frame : *frames)
      parts.push_back(zmq::buffer(frame));
    // A full queue drops the message: the platform notices the gap, and it is
    // sent again (adapters/agents/PROTOCOL.md 4.4).
    zmq::send_multipart(dealer_, parts, zmq::send_flags::dontwait);
    inflow_.go_on();
  }

  void flush_soon() {
    if (is_draining_ || std::exchange(is_flushing_, true))
      return;
    loop_.post([self = shared_from_this()] { self->flush(); });
  }
  void flush() {
    is_flushing_ = false;
    if (!packed_.empty())
      packed_.send(dealer_);
    inflow_.go_on();
  }

  Loop& loop_;
  const ConnectionId id_;
  Owner* owner_; // null: nothing is reported any more
  zmq::context_t zeromq_;
  zmq::socket_t dealer_;
  Inflow inflow_;
  PackedReader reader_;
  // The platform reads packed messages.
  bool packs_ = false;
  PackedLines packed_;
  // drain() is under way, and will flush.
  bool is_draining_ = false;
  // flush() has been posted.
  bool is_flushing_ = false;
};

} // namespace

Expected<std::shared_ptr<PeerConnection>>
connect_by_zeromq(Loop& loop, ConnectionId id, PeerConnection::Owner& owner,
                  const ZeroMQPlatform& platform) {
  try {
    return std::make_shared<ZeroMQConnection>(loop, id, owner, platform);
  } catch (const zmq::error_t& error) {
    return fail(ErrorKind::settings,
                "no connection to " + platform.address + ": " + error.what());
  }
}

} // namespace parlour::adapters::agents
