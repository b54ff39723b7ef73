#include "adapters/agents/zeromq/local_address.hpp"

#include <string>

#include <asio/ip/address.hpp>

namespace parlour::adapters::agents {
namespace {

// The host in "tcp://host:port", without the brackets of IPv6.
std::string host_of(std::string_view address) {
  constexpr std::string_view tcp = "tcp://";
  if (!address.starts_with(tcp))
    return {};
  address.remove_prefix(tcp.size());
  address = address.substr(0, address.rfind(':'));
  if (address.starts_with('[') && address.ends_with(']'))
    address = address.substr(1, address.size() - 2);
  return std::string(address);
}

} // namespace

bool is_local_address(std::string_view address) {
  if (address.starts_with("ipc://") || address.starts_with("inproc://"))
    return true;
  const auto host = host_of(address);
  asio::error_code error;
  const auto parsed = asio::ip::make_address(host, error);
  return host == "localhost" || (!error && parsed.is_loopback());
}

} // namespace parlour::adapters::agents
