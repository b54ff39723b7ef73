// One connection of a WebhookListener: takes one request, answers it, ends.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include <asio/ip/tcp.hpp>
#include <asio/steady_timer.hpp>

#include "adapters/http/webhooks/request_parser.hpp"
#include "runtime/base/clock.hpp"

namespace parlour::adapters::http {

// Used on the loop's thread only. It keeps itself alive while it works.
// The parser may refuse the request before it is complete; else `judge` has the
// last word.
class WebhookConnection
    : public std::enable_shared_from_this<WebhookConnection> {
public:
  // Returns the status of the answer to a complete request.
  using Judge = std::function<int(const WebhookRequest&)>;
  // Called once, when it is over.
  using Over = std::function<void()>;

  WebhookConnection(asio::ip::tcp::socket socket,
                    std::unique_ptr<RequestParser> parser, Judge judge,
                    Over over);

  // Reads the request; after `patience` the connection is closed.
  void start(Milliseconds patience);
  // Closes it; `over` is called.
  void close();

private:
  void read();
  void take(std::string_view bytes);
  void answer(int status);
  void drain();

  asio::ip::tcp::socket socket_;
  asio::steady_timer patience_;
  const std::unique_ptr<RequestParser> parser_;
  const Judge judge_;
  Over over_;
  std::array<char, 4096> buffer_{};
  std::string answer_;
};

} // namespace parlour::adapters::http
