// Where a TCP client connects to.
#pragma once

#include <string>
#include <vector>

#include <sys/socket.h>

#include "runtime/base/error.hpp"

namespace parlour::adapters {

struct Address {
  std::string host;
  std::string port;
};

// "host:port", "192.0.2.1:80" or "[2001:db8::1]:80"; else an error of kind
// Network that says so.
Expected<Address> parse_address(const std::string& text);

// As the system wants it.
struct Endpoint {
  sockaddr_storage address{};
  socklen_t size = 0;
};

} // namespace parlour::adapters
