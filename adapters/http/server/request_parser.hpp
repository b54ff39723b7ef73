// Reads a request in HTTP from bytes as they come.
#pragma once

#include <cstddef>
#include <memory>
#include <string_view>

#include "adapters/http/server/received_request.hpp"

namespace parlour::adapters::http {

class RequestParser {
public:
  // The largest line of the request and headers together, in bytes.
  static constexpr std::size_t max_head = 8 << 10;

  virtual ~RequestParser() = default;

  // Takes the next bytes. 0: more are needed. 200: the request is complete,
  // and what follows is ignored. Else the status by which it is refused: 400
  // (it is no HTTP), 413 (its body is too large) or 431 (its head is).
  virtual int take(std::string_view bytes) = 0;
  // Once it is complete.
  virtual ReceivedRequest request() const = 0;
};

// By Boost.Beast; null if this build lacks it.
std::unique_ptr<RequestParser> make_request_parser(std::size_t max_body);

} // namespace parlour::adapters::http
