// Where something listens, as people write it: "localhost:7000",
// "192.0.2.1:80", "[2001:db8::1]:80".
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace parlour {

struct HostAndPort {
  std::string host; // without brackets
  std::uint16_t port = 0;
};

// Nothing if the text has another form. An address of IPv6 has colons itself,
// so it stands in brackets. Whether port 0 makes sense is for the caller to
// say.
std::optional<HostAndPort> read_host_and_port(std::string_view text);

} // namespace parlour
