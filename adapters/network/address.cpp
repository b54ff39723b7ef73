#include "adapters/network/address.hpp"

#include <charconv>

namespace parlour::adapters {

namespace {

// A number from 1 to 65535 without sign or blanks.
bool is_port(const std::string& text) {
  int number = 0;
  const auto* end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && at == end && number > 0 && number < 65536;
}

} // namespace

Expected<Address> parse_address(const std::string& text) {
  // The last colon separates the port. An IPv6 address has colons itself, so it
  // must be in brackets.
  const auto colon = text.rfind(':');
  Address address;
  if (colon != std::string::npos) {
    address.host = text.substr(0, colon);
    address.port = text.substr(colon + 1);
  }
  auto& host = address.host;
  const bool in_brackets = host.starts_with('[') && host.ends_with(']');
  if (in_brackets)
    host = host.substr(1, host.size() - 2);
  const bool is_host =
      !host.empty() && (in_brackets || host.find(':') == std::string::npos) &&
      host.find_first_of(std::string("\0 /", 3)) == std::string::npos;
  if (!is_host || !is_port(address.port))
    return fail(ErrorKind::network, "'" + text +
                                        "' is no address; write host:port, "
                                        "such as localhost:7000");
  return address;
}

} // namespace parlour::adapters
