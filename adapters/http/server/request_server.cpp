#include "adapters/http/server/request_server.hpp"

#include <map>
#include <utility>

#include "adapters/http/server/request_connection.hpp"
#include "adapters/loop/acceptor_over.hpp"

namespace parlour::adapters::http {

// What it does after listen() is done on the loop's thread.
struct RequestServer::State {
  State(std::unique_ptr<Loop> thread, RequestServerOptions given, Answerer who)
      : options(std::move(given)), answerer(std::move(who)),
        loop(std::move(thread)), acceptor(loop->context()) {}

  Expected<void> listen() {
    asio::error_code error;
    const auto address = asio::ip::make_address(options.address, error);
    if (error)
      return fail(ErrorKind::settings,
                  "'" + options.address + "' is no address of this machine");
    if (auto opened = acceptor.open({address, options.port}); !opened)
      return opened;
    loop->post([this] { accept(); });
    return {};
  }

  bool has_room() const {
    return connections.size() < options.connections;
  }

  void accept() {
    acceptor.accept({[this](auto socket) {
                       if (has_room())
                         add(std::move(socket));
                     },
                     [this] { return options.closes_more || has_room(); }});
  }

  void add(RequestConnection::Socket socket) {
    const auto number = ++last;
    const auto connection = std::make_shared<RequestConnection>(
        std::move(socket), make_request_parser(options.max_body), answerer,
        options.patience, [this, number] {
          connections.erase(number);
          acceptor.go_on();
        });
    connections.emplace(number, connection);
    connection->start();
  }

  void end() {
    acceptor.close();
    while (!connections.empty())
      std::shared_ptr(connections.begin()->second)->close();
  }

  const RequestServerOptions options;
  const Answerer answerer;
  const std::unique_ptr<Loop> loop;
  AcceptorOver<StandaloneAsio> acceptor;
  std::uint64_t last = 0;
  std::map<std::uint64_t, std::shared_ptr<RequestConnection>> connections;
};

Expected<std::unique_ptr<RequestServer>>
RequestServer::start(RequestServerOptions options, Answerer answerer,
                     Loop::Thrown thrown) {
  if (!make_request_parser(options.max_body))
    return fail(ErrorKind::settings, "this program was built without "
                                     "Boost.Beast; install libboost-dev and "
                                     "build it again");
  auto loop = Loop::start(std::move(thrown));
  if (!loop)
    return tl::make_unexpected(std::move(loop.error()));
  std::unique_ptr<RequestServer> server(
      new RequestServer(std::make_unique<State>(
          std::move(*loop), std::move(options), std::move(answerer))));
  if (auto listening = server->state_->listen(); !listening)
    return tl::make_unexpected(std::move(listening.error()));
  return server;
}

RequestServer::RequestServer(std::unique_ptr<State> state)
    : state_(std::move(state)) {}

RequestServer::~RequestServer() {
  state_->loop->post([this] { state_->end(); });
  state_->loop->stop();
}

const std::string& RequestServer::address() const {
  return state_->acceptor.address();
}

} // namespace parlour::adapters::http
