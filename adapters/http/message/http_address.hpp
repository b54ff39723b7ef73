// Addresses of services: read, and written with values in them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace parlour::adapters::http {

// No user, no password and no fragment: read_address() refuses them.
struct HttpAddress {
  std::string scheme; // "http" or "https"
  std::string host;   // in lower case; an IPv6 address with its brackets
  std::uint16_t port = 0;
  std::string target; // path and query, from the first "/"; never empty

  // Whether a request goes to the same server in the same way.
  bool same_origin(const HttpAddress& other) const;
  // "api.example.com", with the port if it is not the usual one: how messages
  // name a service.
  std::string server() const;
};

// Reads an absolute address. The error is the end of a sentence that begins
// with the address, and does not quote it: "begins with neither http:// …".
tl::expected<HttpAddress, std::string> read_address(std::string_view text);

// Each byte but letters, digits and "-._~" as %XX, so that the text is one part
// of a path, a query or a form.
// "a/b c" is "a%2Fb%20c".
std::string percent_encoded(std::string_view text);

// Whether a part of the path is "." or "..", by which one gets to other parts
// of the server. `target` as in HttpAddress.
bool has_dot_segment(std::string_view target);

} // namespace parlour::adapters::http
