// One connection of a RequestServer: takes one request, answers it, ends. An
// internal header of this folder.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "adapters/http/server/answerer.hpp"
#include "adapters/http/server/request_parser.hpp"
#include "adapters/loop/standalone_asio.hpp"
#include "runtime/base/clock.hpp"

namespace parlour::adapters::http {

// Used on the loop's thread only. It keeps itself alive while it works.
class RequestConnection
    : public std::enable_shared_from_this<RequestConnection> {
public:
  using Socket = StandaloneAsio::Socket;
  // Called once, when it is over.
  using Over = std::function<void()>;

  // The answerer outlives it.
  RequestConnection(Socket socket, std::unique_ptr<RequestParser> parser,
                    const Answerer& answerer, Milliseconds patience, Over over);

  // Reads the request. The connection is closed if that takes longer than the
  // patience, or if the other side's reading of the answer does.
  void start();
  // Closes it; `over` is called.
  void close();

private:
  void be_patient();
  void read();
  void take(std::string_view bytes);
  void send(const Reply& reply);
  void drain();

  Socket socket_;
  StandaloneAsio::Timer timer_;
  const std::unique_ptr<RequestParser> parser_;
  const Answerer& answerer_;
  const Milliseconds patience_;
  Over over_;
  std::array<char, 4096> buffer_{};
  std::string answer_;
};

} // namespace parlour::adapters::http
