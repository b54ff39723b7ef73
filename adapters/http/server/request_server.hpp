// RequestServer hears requests in HTTP/1.1 and answers them: one a connection,
// few connections, small requests. One thread serves all of them.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "adapters/http/server/answerer.hpp"
#include "adapters/loop/loop.hpp"
#include "runtime/base/clock.hpp"
#include "runtime/base/error.hpp"

namespace parlour::adapters::http {

struct RequestServerOptions {
  std::string address = "127.0.0.1"; // of this machine
  std::uint16_t port = 0;            // 0: any that is free
  std::size_t max_body = 0;          // bytes
  std::size_t connections = 32;
  // What becomes of more: they are closed at once, or they wait in the system.
  bool closes_more = false;
  // For the request to come, and again for the answer to be read.
  Milliseconds patience{10'000};
};

class RequestServer {
public:
  // Listens at once. `thrown` gets what the answerer throws, on the server's
  // thread. The error is the end of a sentence: why nothing can be heard there,
  // or that this program was built without Boost.Beast.
  static Expected<std::unique_ptr<RequestServer>>
  start(RequestServerOptions options, Answerer answerer, Loop::Thrown thrown);
  RequestServer(const RequestServer&) = delete;
  RequestServer& operator=(const RequestServer&) = delete;
  // Waits for an answer that is being made, and closes all connections.
  ~RequestServer();

  const std::string& address() const; // "127.0.0.1:8090"

private:
  struct State;
  explicit RequestServer(std::unique_ptr<State> state);

  const std::unique_ptr<State> state_;
};

} // namespace parlour::adapters::http
