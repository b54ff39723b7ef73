#include "adapters/web/origin.hpp"

#include <algorithm>
#include <array>

namespace parlour::adapters::web {

namespace {

// "http://localhost:8080" is at the host "localhost".
// An IPv6 address stands in brackets, which belong to it here.
std::string_view host_of(std::string_view origin) {
  const auto scheme = origin.find("://");
  if (scheme == std::string_view::npos)
    return {};
  auto host = origin.substr(scheme + 3);
  if (host.starts_with('['))
    return host.substr(0, host.find(']') + 1);
  return host.substr(0, host.find(':'));
}

} // namespace

bool is_allowed_origin(std::string_view origin,
                       const std::vector<std::string>& allowed) {
  constexpr std::array<std::string_view, 3> here{"localhost", "127.0.0.1",
                                                 "[::1]"};
  return std::ranges::count(here, host_of(origin)) != 0 ||
         std::ranges::count(allowed, origin) != 0;
}

} // namespace parlour::adapters::web
