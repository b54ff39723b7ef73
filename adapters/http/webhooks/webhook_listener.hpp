// WebhookListener hears what services report by themselves: each POST to one of
// its addresses. One request a connection, few connections, small requests, a
// token.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "adapters/http/webhooks/webhook_request.hpp"
#include "adapters/loop/loop.hpp"
#include "runtime/base/clock.hpp"
#include "runtime/base/error.hpp"

namespace parlour::adapters::http {

struct ListenerOptions {
  // "127.0.0.1:8090"; port 0: any that is free. Off loopback there must be a
  // token.
  std::string listen;
  std::string token = {};
  std::size_t max_body = 1 << 20; // bytes
  std::size_t connections = 32;
  // More requests in a second are refused with 429.
  unsigned per_second = 100;
  // How long a request may take to come.
  Milliseconds patience{10'000};
};

// Whether one may listen so. An error of kind Settings says what to write.
Expected<void> check_listener(const ListenerOptions& options);

// Owned by the plug-in, which is called by `take` on another thread than its
// own.
class WebhookListener {
public:
  // Gets each request that is not refused, on the listener's thread, and
  // returns the status of the answer. It must not block.
  using Take = std::function<int(const WebhookRequest&)>;

  // Listens at once, on a thread of its own. `thrown` gets what `take` throws,
  // on that thread; the request is not answered then. The error says which
  // option is wrong, that the port is taken, or that this build lacks
  // Boost.Beast.
  static Expected<std::unique_ptr<WebhookListener>>
  start(ListenerOptions options, Take take, Loop::Thrown thrown);
  WebhookListener(const WebhookListener&) = delete;
  WebhookListener& operator=(const WebhookListener&) = delete;
  // Closes all connections; then nothing is taken any more.
  ~WebhookListener();

  // "http://127.0.0.1:8090".
  const std::string& address() const;

private:
  struct State;
  explicit WebhookListener(std::unique_ptr<State> state);

  const std::unique_ptr<State> state_;
};

} // namespace parlour::adapters::http
