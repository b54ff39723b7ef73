// WebhookListener hears what services report by themselves: each POST to one of
// its addresses. One request a connection, few connections, small requests, a
// token.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "adapters/http/server/request_server.hpp"
#include "adapters/loop/loop.hpp"
#include "runtime/base/clock.hpp"
#include "runtime/base/error.hpp"
#include "runtime/base/rate_limit.hpp"

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
  // How long a request may take to come, and the answer to be read.
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
  using Take = std::function<int(const ReceivedRequest&)>;

  // Listens at once, on a thread of its own. `thrown` gets what `take` throws,
  // on that thread; the request is not answered then. The error says which
  // option is wrong, that the port is taken, or that this build lacks
  // Boost.Beast.
  static Expected<std::unique_ptr<WebhookListener>>
  start(ListenerOptions options, Take take, Loop::Thrown thrown);
  WebhookListener(const WebhookListener&) = delete;
  WebhookListener& operator=(const WebhookListener&) = delete;
  // Closes all connections; then nothing is taken any more.
  ~WebhookListener() = default;

  // "http://127.0.0.1:8090".
  std::string address() const {
    return "http://" + server_->address();
  }

private:
  WebhookListener(const ListenerOptions& options, Take take);

  // On the server's thread.
  Reply judge(const ReceivedRequest& request);

  const std::string token_;
  const Take take_;
  RateLimit rate_; // used on the server's thread only
  std::unique_ptr<RequestServer> server_;
};

} // namespace parlour::adapters::http
