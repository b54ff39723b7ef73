// The address of a TCP server, as scripts write it and as the system needs it.
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

// Parses "host:port", "192.0.2.1:80" or "[2001:db8::1]:80" (language rule
// 11.9). The error has the kind Network.
Expected<Address> parse_address(const std::string& text);

// A resolved address, as connect() takes it.
struct Endpoint {
  sockaddr_storage address{};
  socklen_t size = 0;
};

} // namespace parlour::adapters
