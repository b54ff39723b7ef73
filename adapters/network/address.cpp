#include "adapters/network/address.hpp"

#include "runtime/base/text/host_and_port.hpp"

namespace parlour::adapters {

Expected<Address> parse_address(const std::string& text) {
  auto read = read_host_and_port(text);
  if (!read || read->port == 0)
    return fail(ErrorKind::network, "'" + text +
                                        "' is no address; write host:port, "
                                        "such as localhost:7000");
  return Address{std::move(read->host), std::to_string(read->port)};
}

} // namespace parlour::adapters
