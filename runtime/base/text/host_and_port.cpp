#include "runtime/base/text/host_and_port.hpp"

#include <charconv>

namespace parlour {

namespace {

// Empty if it is none.
std::string_view host_in(std::string_view text) {
  const bool in_brackets =
      text.size() > 2 && text.starts_with('[') && text.ends_with(']');
  if (in_brackets)
    text = text.substr(1, text.size() - 2);
  const std::string_view foreign = in_brackets ? std::string_view("\0 /[]", 5)
                                               : std::string_view("\0 /[]:", 6);
  return text.find_first_of(foreign) == std::string_view::npos
             ? text
             : std::string_view();
}

} // namespace

std::optional<HostAndPort> read_host_and_port(std::string_view text) {
  const auto colon = text.rfind(':');
  if (colon == std::string_view::npos)
    return std::nullopt;
  HostAndPort result{std::string(host_in(text.substr(0, colon)))};
  const auto port = text.substr(colon + 1);
  const auto* const end = port.data() + port.size();
  const auto [at, error] = std::from_chars(port.data(), end, result.port);
  if (result.host.empty() || error != std::errc() || at != end)
    return std::nullopt;
  return result;
}

} // namespace parlour
