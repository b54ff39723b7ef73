// PageServer: a few pages over HTTP/1.1, for programs that watch this one. A
// connection gets one answer and is closed. One thread serves all of them.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "adapters/http/server/request_server.hpp"
#include "runtime/base/clock.hpp"
#include "runtime/base/error.hpp"

namespace parlour::adapters::web {

struct Page {
  bool is_well = true; // else the status is 503
  std::string text;
  std::string content_type = "text/plain; charset=utf-8";
};

struct PageServerOptions {
  std::string address = "127.0.0.1"; // of this machine
  std::uint16_t port = 0;            // 0: any that is free
  // By their paths, such as "/metrics". They are made anew for each request, on
  // the server's thread.
  std::map<std::string, std::function<Page()>> pages;
  // More are closed at once.
  std::size_t connections = 16;
  // For the request to come, and again for the answer to be read.
  Milliseconds patience{5'000};
};

// What `parlour serve` shows to Prometheus and to load balancers
// (docs/operations.md). GET and HEAD only; no request has a body.
class PageServer {
public:
  // Gets what() of an exception, on the server's thread.
  using Thrown = std::function<void(const std::string& what)>;

  // The error says why nothing can be heard there, or that this program was
  // built without it. A std::exception of a page is answered by the status 500;
  // of any other, and of the server's own, `thrown` is told.
  static Expected<std::unique_ptr<PageServer>> start(PageServerOptions options,
                                                     Thrown thrown);
  // Waits for a page that is being made.
  ~PageServer() = default;

  std::string address() const { // "127.0.0.1:9464"
    return server_->address();
  }

private:
  using Pages = std::map<std::string, std::function<Page()>>;
  explicit PageServer(Pages pages) : pages_(std::move(pages)) {}

  // On the server's thread.
  adapters::http::Reply
  answer(const adapters::http::ReceivedRequest& request) const;
  adapters::http::Reply refuse(int status) const;

  const Pages pages_;
  std::unique_ptr<adapters::http::RequestServer> server_;
};

} // namespace parlour::adapters::web
