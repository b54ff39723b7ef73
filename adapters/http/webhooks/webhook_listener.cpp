#include "adapters/http/webhooks/webhook_listener.hpp"

#include <future>
#include <map>
#include <memory>
#include <utility>

#include <asio/error.hpp>
#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/steady_timer.hpp>

#include "adapters/http/webhooks/webhook_connection.hpp"
#include "runtime/base/rate_limit.hpp"
#include "runtime/base/text/host_and_port.hpp"

namespace parlour::adapters::http {

namespace {

using asio::ip::tcp;

// While the process has too many files open, accepting fails at once, again and
// again.
constexpr Milliseconds pause_between{200};

// "127.0.0.1:8090", "[::1]:8090".
Expected<tcp::endpoint> endpoint_of(const std::string& listen) {
  if (const auto read = read_host_and_port(listen)) {
    asio::error_code error;
    const auto address = asio::ip::make_address(read->host, error);
    if (!error)
      return tcp::endpoint(address, read->port);
  }
  return fail(ErrorKind::settings,
              "the option 'listen' is an address of this machine with a port, "
              "such as 127.0.0.1:8090, not '" +
                  listen + "'");
}

std::string text_of(const tcp::endpoint& end) {
  const auto host = end.address().to_string();
  return "http://" + (end.address().is_v6() ? '[' + host + ']' : host) + ':' +
         std::to_string(end.port());
}

} // namespace

Expected<void> check_listener(const ListenerOptions& options) {
  const auto end = endpoint_of(options.listen);
  if (!end)
    return tl::make_unexpected(end.error());
  if (!end->address().is_loopback() && options.token.empty())
    return fail(ErrorKind::settings,
                options.listen +
                    " can be reached from other machines: give a 'token', or "
                    "listen on 127.0.0.1");
  return {};
}

// All of it runs on one loop; the public class only posts to it.
struct WebhookListener::State {
  State(std::unique_ptr<Loop> thread, ListenerOptions given, Take function)
      : options(std::move(given)), take(std::move(function)),
        loop(std::move(thread)), acceptor(loop->context()),
        pause(loop->context()), rate(options.per_second) {}

  // Each step is taken only if the one before has succeeded.
  Expected<void> listen(const tcp::endpoint& end) {
    asio::error_code error;
    acceptor.open(end.protocol(), error);
    if (!error)
      acceptor.set_option(tcp::acceptor::reuse_address(true), error);
    if (!error)
      acceptor.bind(end, error);
    if (!error)
      acceptor.listen(asio::socket_base::max_listen_connections, error);
    if (error)
      return fail(ErrorKind::network, "webhooks cannot be heard at " +
                                          options.listen + ": " +
                                          error.message());
    address = text_of(acceptor.local_endpoint());
    accept();
    return {};
  }

  // Beyond the bound nobody is accepted: connections wait in the system.
  void accept() {
    if (!acceptor.is_open() || connections.size() >= options.connections)
      return;
    acceptor.async_accept([this](asio::error_code error, tcp::socket socket) {
      if (error == asio::error::operation_aborted)
        return;
      if (error)
        return accept_later();
      add(std::move(socket));
      accept();
    });
  }

  void accept_later() {
    pause.expires_after(pause_between);
    pause.async_wait([this](asio::error_code error) {
      if (!error)
        accept();
    });
  }

  void add(tcp::socket socket) {
    auto over = std::make_shared<std::function<void()>>();
    const auto connection = std::make_shared<WebhookConnection>(
        std::move(socket), make_request_parser(options.max_body),
        [this](const WebhookRequest& request) { return judge(request); },
        [over] { (*over)(); });
    *over = [this, one = connection.get()] { remove(one); };
    connections.emplace(connection.get(), connection);
    connection->start(options.patience);
  }

  void remove(WebhookConnection* connection) {
    const bool was_full = connections.size() >= options.connections;
    connections.erase(connection);
    if (was_full)
      accept();
  }

  // Too many are refused before their token is looked at: guessing is slowed
  // down, too.
  int judge(const WebhookRequest& request) {
    if (!rate.admit(std::chrono::steady_clock::now()))
      return 429;
    const auto refusal = refusal_of(request, options.token);
    return refusal != 0 ? refusal : take(request);
  }

  void end() {
    asio::error_code ignored; // it may never have been open
    acceptor.close(ignored);
    pause.cancel();
    while (!connections.empty())
      std::shared_ptr(connections.begin()->second)->close();
  }

  const ListenerOptions options;
  const Take take;
  const std::unique_ptr<Loop> loop;
  // The rest is used on the loop's thread, but for the address, which does not
  // change any more.
  tcp::acceptor acceptor;
  asio::steady_timer pause;
  RateLimit rate;
  std::string address;
  std::map<WebhookConnection*, std::shared_ptr<WebhookConnection>> connections;
};

// Returns when the port is open, as the error is to be told by the start.
Expected<std::unique_ptr<WebhookListener>>
WebhookListener::start(ListenerOptions options, Take take,
                       Loop::Thrown thrown) {
  if (auto may = check_listener(options); !may)
    return tl::make_unexpected(may.error());
  if (!make_request_parser(options.max_body))
    return fail(ErrorKind::settings,
                "this program was built without Boost.Beast, so it hears no "
                "webhooks; install libboost-dev and build it again");
  const auto end = endpoint_of(options.listen);
  auto loop = Loop::start(std::move(thrown));
  if (!loop)
    return tl::make_unexpected(loop.error());
  auto state = std::make_unique<State>(std::move(*loop), std::move(options),
                                       std::move(take));
  std::promise<Expected<void>> listening;
  state->loop->post([&] { listening.set_value(state->listen(*end)); });
  if (auto done = listening.get_future().get(); !done) {
    state->loop->stop();
    return tl::make_unexpected(done.error());
  }
  return std::unique_ptr<WebhookListener>(
      new WebhookListener(std::move(state)));
}

WebhookListener::WebhookListener(std::unique_ptr<State> state)
    : state_(std::move(state)) {}

WebhookListener::~WebhookListener() {
  state_->loop->post([this] { state_->end(); });
  state_->loop->stop();
}

const std::string& WebhookListener::address() const {
  return state_->address;
}

} // namespace parlour::adapters::http
