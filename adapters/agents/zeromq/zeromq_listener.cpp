#include "adapters/agents/zeromq/zeromq_listener.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include <zmq.hpp>
#include <zmq_addon.hpp>

#include "adapters/agents/wire/multipart.hpp"
#include "adapters/agents/zeromq/inflow.hpp"
#include "adapters/agents/zeromq/key_pair.hpp"
#include "adapters/agents/zeromq/local_address.hpp"
#include "adapters/agents/zeromq/packed_lines.hpp"

namespace parlour::adapters::agents {
namespace {

// The frames as texts. They are valid as long as the frames.
std::vector<std::string_view> texts(const std::vector<zmq::message_t>& frames) {
  std::vector<std::string_view> all;
  for (const auto& frame : frames)
    all.push_back(frame.to_string_view());
  return all;
}

// The transport by ZeroMQ. ZeroMQ has no connections, only names of peers: a
// peer counts as connected from its first message on.
class ZeroMQListener : public AgentTransport {
public:
  ZeroMQListener(Loop& loop, TransportEvents& events,
                 const ZeroMQOptions& options)
      : loop_(loop), events_(events), allowed_(options.allowed_keys),
        is_loopback_(is_local_address(options.address)),
        router_(zeromq_, zmq::socket_type::router),
        inflow_(loop, router_, [this] { drain(); }) {
    router_.set(zmq::sockopt::linger, 0);
    // A message to a peer that has gone is an error; otherwise it would be
    // dropped silently.
    router_.set(zmq::sockopt::router_mandatory, true);
    // A frame beyond this ends the connection. One between this and the
    // protocol's limit gets an answer.
    router_.set(zmq::sockopt::maxmsgsize,
                static_cast<std::int64_t>(2 * max_message_bytes));
    router_.set(zmq::sockopt::ipv6, options.address.starts_with("tcp://["));
    if (!options.secret_key.empty())
      encrypt(loop, options.secret_key);
    router_.bind(options.address);
    inflow_.go_on();
  }

  bool is_loopback() const override {
    return is_loopback_;
  }
  bool has(ConnectionId id) const override {
    return peers_.contains(id);
  }

  void write(ConnectionId id, const AgentMessage& message) override {
    auto& peer = peers_.at(id);
    if (!peer.packs)
      return send(id, peer, message);
    if (!may_be_packed(message)) {
      send_packed(id, peer);
      return send(id, peer, message);
    }
    if (peer.packed.empty())
      to_be_sent_.push_back(id);
    peer.packed.add(message);
    if (peer.packed.is_full())
      send_packed(id, peer);
    flush_soon();
  }
  void pack(ConnectionId id) override {
    peers_.at(id).packs = true;
  }

  void close(ConnectionId id) override {
    const auto found = peers_.find(id);
    if (found == peers_.end())
      return;
    send_packed(id, found->second);
    ids_.erase(found->second.name);
    peers_.erase(found);
  }
  void shut() override {
    is_shut_ = true;
    flush();
    inflow_.stop();
    if (questions_inflow_)
      questions_inflow_->stop();
    peers_.clear();
    ids_.clear();
  }
  std::string address() const override {
    return router_.get(zmq::sockopt::last_endpoint);
  }

private:
  // How many messages are taken before others have their turn.
  static constexpr int max_at_once = 100;
  // More frames than a message can have: what follows them is not kept.
  static constexpr std::size_t max_frames = max_parameters + 16;

  // Another side of a connection.
  struct Peer {
    std::string name;
    // It reads packed messages.
    bool packs = false;
    PackedLines packed = {};
  };

  // What is written meanwhile leaves together at the end.
  void drain() {
    is_draining_ = true;
    std::vector<zmq::message_t> frames;
    for (int i = 0; i < max_at_once && !is_shut_; ++i) {
      receive(frames);
      if (frames.empty())
        break;
      take(frames);
      if (is_packed(frames))
        break; // those were many
    }
    is_draining_ = false;
    flush();
    for (const auto id : std::exchange(lost_, {}))
      if (has(id)) {
        close(id);
        events_.closed(id);
      }
  }

  // -- what leaves ------------------------------------------------------------

  // Each field as a frame.
  void send(ConnectionId id, const Peer& peer, const AgentMessage& message) {
    const auto frames = frames_of(message);
    if (!frames)
      // The exchange has checked messages that are to be delivered.
      return;
    std::vector<zmq::const_buffer> parts = {zmq::buffer(peer.name)};
    for (const auto& frame : *frames)
      parts.push_back(zmq::buffer(frame));
    // A full queue drops the message: the receiver notices the gap, and it is
    // sent again (adapters/agents/PROTOCOL.md 4.4).
    try_to(id, [&] {
      zmq::send_multipart(router_, parts, zmq::send_flags::dontwait);
    });
    inflow_.go_on();
  }

  void send_packed(ConnectionId id, Peer& peer) {
    if (peer.packed.empty())
      return;
    try_to(id, [&] {
      router_.send(zmq::buffer(peer.name),
                   zmq::send_flags::sndmore | zmq::send_flags::dontwait);
      peer.packed.send(router_);
    });
  }

  template <class Send>
  void try_to(ConnectionId id, Send&& send) {
    try {
      send();
    } catch (const zmq::error_t&) {
      // No peer has this name any more. It is reported by drain(), outside of
      // the exchange's call.
      lost_.push_back(id);
    }
  }

  void flush_soon() {
    if (is_draining_ || std::exchange(is_flushing_, true))
      return;
    loop_.post([this, life = std::weak_ptr<bool>(life_)] {
      if (!life.expired())
        flush();
    });
  }
  void flush() {
    is_flushing_ = false;
    for (const auto id : to_be_sent_)
      if (const auto found = peers_.find(id); found != peers_.end())
        send_packed(id, found->second);
    to_be_sent_.clear();
    inflow_.go_on();
  }

  // -- what arrives -----------------------------------------------------------

  // The frames of a message; none if there is no message.
  void receive(std::vector<zmq::message_t>& frames) {
    frames.clear();
    bool more = true;
    while (more) {
      zmq::message_t frame;
      if (!router_.recv(frame, zmq::recv_flags::dontwait))
        break;
      more = frame.more();
      if (frames.size() < max_frames)
        frames.push_back(std::move(frame));
    }
  }

  static bool is_packed(const std::vector<zmq::message_t>& frames) {
    return frames.size() == 2;
  }

  // The first frame is the peer's name, which ROUTER adds.
  void take(const std::vector<zmq::message_t>& frames) {
    const auto id = id_of(frames);
    events_.heard(id);
    if (is_packed(frames))
      return reader_.read(frames.back().to_string_view(),
                          [&](Read<AgentMessage>&& message) {
                            if (has(id)) // it may be closed at any message
                              events_.arrived(id, std::move(message));
                          });
    auto fields = texts(frames);
    fields.erase(fields.begin());
    events_.arrived(id, read_frames(std::move(fields)));
  }

  // The connection of a message; a new name opens one. The key with which the
  // peer has authenticated is the property "User-Id" of its messages.
  ConnectionId id_of(const std::vector<zmq::message_t>& frames) {
    auto name = frames.front().to_string();
    auto key = questions_ ? property(frames.back(), "User-Id") : std::string();
    if (const auto found = ids_.find(name); found != ids_.end()) {
      const auto [id, former_key] = found->second;
      if (former_key == key)
        return id;
      // Peers choose their names themselves: another one has taken this name.
      close(id);
      events_.closed(id);
    }
    const auto id = events_.next_id();
    ids_[name] = {id, key};
    peers_[id].name = std::move(name);
    events_.opened(id, {property(frames.back(), "Peer-Address"), std::move(key),
                        !is_loopback_});
    return id;
  }

  static std::string property(const zmq::message_t& message, const char* name) {
    const auto* value =
        zmq_msg_gets(const_cast<zmq_msg_t*>(message.handle()), name);
    return value ? value : "";
  }

  // -- CURVE ------------------------------------------------------------------

  // Encrypts and authenticates by CURVE. ZeroMQ asks a socket of ours (ZAP, its
  // RFC 27) for each connection whether the key may connect.
  void encrypt(Loop& loop, const std::string& secret_key) {
    router_.set(zmq::sockopt::curve_server, true);
    router_.set(zmq::sockopt::curve_secretkey, secret_key);
    router_.set(zmq::sockopt::zap_domain, "parlour");
    questions_.emplace(zeromq_, zmq::socket_type::rep);
    questions_->set(zmq::sockopt::linger, 0);
    questions_->bind("inproc://zeromq.zap.01");
    questions_inflow_.emplace(loop, *questions_,
                              [this] { answer_questions(); });
    questions_inflow_->go_on();
  }

  void answer_questions() {
    std::vector<zmq::message_t> question;
    while (zmq::recv_multipart(*questions_, std::back_inserter(question),
                               zmq::recv_flags::dontwait)) {
      answer(texts(question));
      question.clear();
    }
  }

  // A question has version, id, domain, address, identity, mechanism and key.
  void answer(const std::vector<std::string_view>& question) {
    std::string key(key_characters + 1, '\0');
    if (question.size() == 7 && question[5] == "CURVE" &&
        question[6].size() == 32)
      zmq_z85_encode(key.data(),
                     reinterpret_cast<const std::uint8_t*>(question[6].data()),
                     question[6].size());
    key.pop_back();
    const bool may = std::ranges::find(allowed_, key) != allowed_.end();
    if (!may)
      events_.turned_away(
          excerpt(question.size() > 3 ? question[3] : "a stranger"),
          {WireErrorKind::identity, "no agent has its key"});
    const std::string id(question.size() > 1 ? question[1] : "");
    const std::array<std::string, 6> reply = {
        "1.0",          id, may ? "200" : "400", may ? "OK" : "unknown key",
        may ? key : "", ""};
    std::vector<zmq::const_buffer> parts;
    for (const auto& part : reply)
      parts.push_back(zmq::buffer(part));
    zmq::send_multipart(*questions_, parts);
  }

  Loop& loop_;
  TransportEvents& events_;
  const std::vector<std::string> allowed_;
  const bool is_loopback_;
  zmq::context_t zeromq_;
  zmq::socket_t router_;
  Inflow inflow_;
  std::optional<zmq::socket_t> questions_;
  std::optional<Inflow> questions_inflow_;
  PackedReader reader_;
  std::map<ConnectionId, Peer> peers_;
  // With the key of each.
  std::map<std::string, std::pair<ConnectionId, std::string>> ids_;
  std::vector<ConnectionId> lost_;
  // Those for which something is packed.
  std::vector<ConnectionId> to_be_sent_;
  bool is_shut_ = false;
  // drain() is under way, and will flush.
  bool is_draining_ = false;
  // flush() has been posted.
  bool is_flushing_ = false;
  // What is posted runs only while it is there.
  const std::shared_ptr<bool> life_ = std::make_shared<bool>();
};

// Without keys, only loopback may be used.
Expected<void> check(const ZeroMQOptions& options) {
  if (!options.secret_key.empty() &&
      options.secret_key.size() != key_characters)
    return fail(ErrorKind::settings,
                "a key has 40 characters; `parlour keygen` makes a pair");
  if (options.secret_key.empty() && !is_local_address(options.address))
    return fail(ErrorKind::settings,
                options.address + " can be reached from other hosts: give "
                                  "keys (`parlour keygen`), or listen on "
                                  "127.0.0.1");
  return {};
}

} // namespace

Expected<std::unique_ptr<AgentTransport>>
listen_by_zeromq(Loop& loop, TransportEvents& events,
                 const ZeroMQOptions& options) {
  if (auto checked = check(options); !checked)
    return tl::make_unexpected(std::move(checked.error()));
  try {
    return std::make_unique<ZeroMQListener>(loop, events, options);
  } catch (const zmq::error_t& error) {
    return fail(ErrorKind::network, "agents cannot connect to " +
                                        options.address + ": " + error.what());
  }
}

} // namespace parlour::adapters::agents
