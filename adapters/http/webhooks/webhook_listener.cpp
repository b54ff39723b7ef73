#include "adapters/http/webhooks/webhook_listener.hpp"

#include <chrono>
#include <utility>

#include <asio/ip/address.hpp>

#include "adapters/http/webhooks/webhook_request.hpp"
#include "runtime/base/text/host_and_port.hpp"

namespace parlour::adapters::http {

namespace {

struct Place {
  HostAndPort named;
  bool is_loopback = true;
};

// "127.0.0.1:8090", "[::1]:8090".
Expected<Place> place_of(const std::string& listen) {
  if (auto read = read_host_and_port(listen)) {
    asio::error_code error;
    const auto address = asio::ip::make_address(read->host, error);
    if (!error)
      return Place{std::move(*read), address.is_loopback()};
  }
  return fail(ErrorKind::settings,
              "the option 'listen' is an address of this machine with a port, "
              "such as 127.0.0.1:8090, not '" +
                  listen + "'");
}

RequestServerOptions server_options(const ListenerOptions& options,
                                    HostAndPort place) {
  return {.address = std::move(place.host),
          .port = place.port,
          .max_body = options.max_body,
          .connections = options.connections,
          .patience = options.patience};
}

} // namespace

Expected<void> check_listener(const ListenerOptions& options) {
  const auto place = place_of(options.listen);
  if (!place)
    return tl::make_unexpected(place.error());
  if (!place->is_loopback && options.token.empty())
    return fail(ErrorKind::settings,
                options.listen +
                    " can be reached from other machines: give a 'token', or "
                    "listen on 127.0.0.1");
  return {};
}

Expected<std::unique_ptr<WebhookListener>>
WebhookListener::start(ListenerOptions options, Take take,
                       Loop::Thrown thrown) {
  if (auto may = check_listener(options); !may)
    return tl::make_unexpected(may.error());
  std::unique_ptr<WebhookListener> listener(
      new WebhookListener(options, std::move(take)));
  auto server = RequestServer::start(
      server_options(options, place_of(options.listen)->named),
      {[self = listener.get()](const auto& request) {
        return self->judge(request);
      }},
      std::move(thrown));
  if (!server)
    return fail(server.error().kind, "webhooks cannot be heard at " +
                                         options.listen + ": " +
                                         server.error().message);
  listener->server_ = std::move(*server);
  return listener;
}

WebhookListener::WebhookListener(const ListenerOptions& options, Take take)
    : token_(options.token), take_(std::move(take)), rate_(options.per_second) {
}

// Too many are refused before their token is looked at: guessing is slowed
// down, too.
Reply WebhookListener::judge(const ReceivedRequest& request) {
  if (!rate_.admit(std::chrono::steady_clock::now()))
    return {.status = 429, .headers = "Retry-After: 1\r\n"};
  if (const auto refusal = refusal_of(request, token_); refusal != 0)
    return {.status = refusal,
            .headers = refusal == 405 ? "Allow: POST\r\n" : ""};
  return {.status = take_(request)};
}

} // namespace parlour::adapters::http
