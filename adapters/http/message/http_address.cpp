#include "adapters/http/message/http_address.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>

namespace parlour::adapters::http {

namespace {

using Unexpected = tl::unexpected<std::string>;

bool is_letter_or_digit(unsigned char byte) {
  return byte < 0x80 && std::isalnum(byte) != 0;
}

std::string lower(std::string_view text) {
  std::string result(text);
  for (auto& byte : result)
    byte = static_cast<char>(std::tolower(static_cast<unsigned char>(byte)));
  return result;
}

std::uint16_t usual_port(std::string_view scheme) {
  return scheme == "https" ? 443 : 80;
}

// "host", "host:port", "[::1]:port". False if it has another form.
// Stricter than the standard: what has another form is refused before it is
// sent anywhere.
bool read_server(std::string_view text, HttpAddress& address) {
  const auto bracket = text.starts_with('[') ? text.find(']') : 0;
  if (bracket == std::string_view::npos)
    return false;
  const auto colon = text.find(':', bracket);
  const auto host = text.substr(0, colon);
  const bool is_number = bracket != 0;
  const auto fits = [is_number](unsigned char byte) {
    return is_letter_or_digit(byte) || byte == '.' || byte == '-' ||
           byte == '_' ||
           (is_number && (byte == ':' || byte == '[' || byte == ']'));
  };
  if (host.empty() || !std::ranges::all_of(host, fits))
    return false;
  address.host = lower(host);
  address.port = usual_port(address.scheme);
  if (colon == std::string_view::npos)
    return true;
  const auto port = text.substr(colon + 1);
  const auto* const end = port.data() + port.size();
  const auto read = std::from_chars(port.data(), end, address.port);
  return read.ec == std::errc() && read.ptr == end && address.port > 0;
}

} // namespace

bool HttpAddress::same_origin(const HttpAddress& other) const {
  return scheme == other.scheme && host == other.host && port == other.port;
}

std::string HttpAddress::server() const {
  return port == usual_port(scheme) ? host : host + ':' + std::to_string(port);
}

// The scheme is read first, as the usual port depends on it.
tl::expected<HttpAddress, std::string> read_address(std::string_view text) {
  HttpAddress address;
  const auto colon = text.find("://");
  address.scheme = lower(text.substr(0, std::min(colon, text.size())));
  if (colon == std::string_view::npos ||
      (address.scheme != "http" && address.scheme != "https"))
    return Unexpected("begins with neither http:// nor https://");
  if (std::ranges::any_of(
          text, [](char byte) { return byte <= ' ' || byte >= 0x7f; }))
    return Unexpected("has a blank or a sign that must be written as %XX");
  if (text.find('#') != std::string_view::npos)
    return Unexpected("has a '#', which is for browsers");
  const auto rest = text.substr(colon + 3);
  const auto end = std::min(rest.find_first_of("/?"), rest.size());
  const auto server = rest.substr(0, end);
  if (server.find('@') != std::string_view::npos)
    return Unexpected("has a user or a password; write them as a <header "
                      "name=\"Authorization\">");
  if (!read_server(server, address))
    return Unexpected("has no server such as api.example.com or "
                      "127.0.0.1:8080");
  address.target = rest.substr(end);
  if (!address.target.starts_with('/'))
    address.target.insert(0, "/");
  return address;
}

std::string percent_encoded(std::string_view text) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string result;
  for (const char one : text) {
    const auto byte = static_cast<unsigned char>(one);
    if (is_letter_or_digit(byte) || byte == '-' || byte == '.' || byte == '_' ||
        byte == '~') {
      result += static_cast<char>(byte);
    } else {
      result += '%';
      result += digits[byte >> 4];
      result += digits[byte & 15];
    }
  }
  return result;
}

bool has_dot_segment(std::string_view target) {
  const auto path = target.substr(0, target.find('?'));
  for (std::size_t at = 0; at != std::string_view::npos;) {
    const auto end = path.find('/', at);
    const auto part =
        path.substr(at, end == std::string_view::npos ? end : end - at);
    if (part == "." || part == "..")
      return true;
    at = end == std::string_view::npos ? end : end + 1;
  }
  return false;
}

} // namespace parlour::adapters::http
