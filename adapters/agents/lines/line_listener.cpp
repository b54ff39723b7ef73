#include "adapters/agents/lines/line_listener.hpp"

#include <map>
#include <optional>

#include <fmt/format.h>

#include "adapters/agents/lines/line_connection.hpp"
#include "adapters/loop/acceptor_over.hpp"

namespace parlour::adapters::agents {
namespace {

using asio::ip::tcp;
using PlainStream = LineSocket;
using SecureStream = asio::ssl::stream<LineSocket>;

// The transport of lines: accepts connections and passes events on.
class LineListener : public AgentTransport, private PeerConnection::Owner {
public:
  LineListener(asio::io_context& context, TransportEvents& events)
      : acceptor_(context), events_(events) {}

  Expected<void> listen(const LineOptions& options) {
    asio::error_code error;
    const auto address = asio::ip::make_address(options.address, error);
    if (error)
      return fail(ErrorKind::settings,
                  "'" + options.address + "' is no address of this host");
    if (!options.certificate.empty() || !options.private_key.empty())
      if (auto read = read_certificate(options); !read)
        return read;
    is_loopback_ = address.is_loopback();
    // Without TLS the token of an agent would be readable on the network.
    if (!is_loopback_ && !certificate_)
      return fail(ErrorKind::settings,
                  options.address + " can be reached from other hosts: give a "
                                    "certificate and a private_key for TLS, or "
                                    "listen on 127.0.0.1");
    return bind({address, options.port});
  }

  void accept() {
    acceptor_.accept(
        {[this](LineSocket socket) { add(std::move(socket)); },
         {},
         [this](const std::string& why) { events_.not_accepted(why); }});
  }

  bool is_loopback() const override {
    return is_loopback_;
  }
  bool has(ConnectionId id) const override {
    return connections_.contains(id);
  }
  void write(ConnectionId id, const AgentMessage& message) override {
    connections_.at(id)->write(message);
  }
  void close(ConnectionId id) override {
    if (const auto found = connections_.extract(id))
      found.mapped()->close();
  }
  void shut() override {
    acceptor_.close();
    for (const auto& [id, connection] : std::exchange(connections_, {}))
      connection->close();
  }
  std::string address() const override {
    return "tcp://" + acceptor_.address();
  }

private:
  // The certificate may be followed by those of its issuers (a chain).
  Expected<void> read_certificate(const LineOptions& options) {
    certificate_.emplace(asio::ssl::context::tls_server);
    SSL_CTX_set_min_proto_version(certificate_->native_handle(),
                                  TLS1_2_VERSION);
    asio::error_code error;
    certificate_->use_certificate_chain_file(options.certificate, error);
    if (error)
      return fail(ErrorKind::settings, "the certificate '" +
                                           options.certificate +
                                           "': " + error.message());
    certificate_->use_private_key_file(options.private_key,
                                       asio::ssl::context::pem, error);
    if (error)
      return fail(ErrorKind::settings, "the private key '" +
                                           options.private_key +
                                           "': " + error.message());
    return {};
  }

  Expected<void> bind(const tcp::endpoint& end) {
    if (auto opened = acceptor_.open(end); !opened)
      return fail(ErrorKind::network,
                  fmt::format("agents cannot connect to {}:{}: {}",
                              end.address().to_string(), end.port(),
                              opened.error().message));
    return {};
  }

  // Under TLS if there is a certificate.
  std::shared_ptr<PeerConnection> connection_over(LineSocket socket,
                                                  ConnectionId id) {
    Owner& owner = *this;
    if (!certificate_)
      return std::make_shared<LineConnectionOver<PlainStream>>(
          std::move(socket), id, owner);
    return std::make_shared<LineConnectionOver<SecureStream>>(
        SecureStream(std::move(socket), *certificate_), id, owner);
  }

  void add(LineSocket socket) {
    asio::error_code error;
    const auto end = socket.remote_endpoint(error);
    if (error)
      // The other side has closed it already.
      return;
    const auto id = events_.next_id();
    const auto connection = connection_over(std::move(socket), id);
    connections_[id] = connection;
    connection->start();
    // A line has no key: agents authenticate by token.
    events_.opened(id,
                   {fmt::format("{}:{}", end.address().to_string(), end.port()),
                    {},
                    !is_loopback_});
  }

  void heard(ConnectionId id) override {
    events_.heard(id);
  }
  void arrived(ConnectionId id, Read<AgentMessage>&& message) override {
    events_.arrived(id, std::move(message));
  }
  void lost(ConnectionId id) override {
    connections_.erase(id);
    events_.closed(id);
  }

  AcceptorOver<StandaloneAsio> acceptor_;
  bool is_loopback_ = true;
  TransportEvents& events_;
  std::optional<asio::ssl::context> certificate_;
  std::map<ConnectionId, std::shared_ptr<PeerConnection>> connections_;
};

} // namespace

Expected<std::unique_ptr<AgentTransport>>
listen_for_lines(Loop& loop, TransportEvents& events,
                 const LineOptions& options) {
  auto listener = std::make_unique<LineListener>(loop.context(), events);
  if (auto listening = listener->listen(options); !listening)
    return tl::make_unexpected(std::move(listening.error()));
  listener->accept();
  return listener;
}

} // namespace parlour::adapters::agents
