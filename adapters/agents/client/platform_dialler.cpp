#include "adapters/agents/client/platform_dialler.hpp"

#include <optional>
#include <utility>

#include <asio.hpp>
#include <asio/ssl.hpp>
#include <fmt/format.h>

#include "adapters/agents/lines/line_connection.hpp"
#include "adapters/agents/zeromq/zeromq_connection.hpp"

namespace parlour::adapters::agents {
namespace {

using asio::ip::tcp;
using SecureStream = asio::ssl::stream<LineSocket>;

class Dialler : public PlatformDialler {
public:
  Dialler(Loop& loop, PlatformAddress address)
      : loop_(loop), address_(std::move(address)), resolver_(loop.context()) {}

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

  void dial(ConnectionId id, PeerConnection::Owner& owner, Done done) override {
    if (address_.is_zeromq)
      return done(by_zeromq(id, owner));
    resolver_.async_resolve(
        address_.host, address_.port,
        [this, id, &owner, done = std::move(done)](
            asio::error_code error, const tcp::resolver::results_type& found) {
          if (error)
            return done(fail(ErrorKind::network, error.message()));
          auto socket = std::make_shared<LineSocket>(loop_.context());
          asio::async_connect(
              *socket, found,
              [this, socket, id, &owner, done](asio::error_code failed,
                                               const tcp::endpoint&) {
                failed ? done(fail(ErrorKind::network, failed.message()))
                       : done(over(std::move(*socket), id, owner));
              });
        });
  }

  void cancel() override {
    resolver_.cancel();
  }

private:
  // ZeroMQ finds and tries the address by itself.
  Connected by_zeromq(ConnectionId id, PeerConnection::Owner& owner) {
    const bool is_v6 = address_.host.find(':') != std::string::npos;
    ZeroMQPlatform platform;
    platform.address = fmt::format(
        "tcp://{}:{}", is_v6 ? "[" + address_.host + "]" : address_.host,
        address_.port);
    platform.own = address_.own_keys;
    platform.platform_key = address_.platform_key;
    return connect_by_zeromq(loop_, id, owner, platform);
  }

  std::shared_ptr<PeerConnection> over(LineSocket socket, ConnectionId id,
                                       PeerConnection::Owner& owner) {
    if (!tls_)
      return std::make_shared<LineConnectionOver<LineSocket>>(std::move(socket),
                                                              id, owner);
    SecureStream stream(std::move(socket), *tls_);
    stream.set_verify_callback(
        asio::ssl::host_name_verification(address_.host));
    return std::make_shared<LineConnectionOver<SecureStream>>(
        std::move(stream), id, owner, asio::ssl::stream_base::client);
  }

  Loop& loop_;
  const PlatformAddress address_;
  std::optional<asio::ssl::context> tls_;
  tcp::resolver resolver_;
};

} // namespace

Expected<std::unique_ptr<PlatformDialler>>
PlatformDialler::make(Loop& loop, PlatformAddress address) {
  auto dialler = std::make_unique<Dialler>(loop, std::move(address));
  if (auto prepared = dialler->prepare(); !prepared)
    return tl::make_unexpected(std::move(prepared.error()));
  return dialler;
}

} // namespace parlour::adapters::agents
