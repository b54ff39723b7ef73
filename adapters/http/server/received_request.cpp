#include "adapters/http/server/received_request.hpp"

#include <algorithm>
#include <charconv>
#include <cstddef>

namespace parlour::adapters::http {

namespace {

// "%XX" at the beginning of the text, as a byte; -1: it is none.
int escaped_byte(std::string_view text) {
  int byte = 0;
  if (text.size() < 3 || text[0] != '%')
    return -1;
  const auto* const end = text.data() + 3;
  const auto read = std::from_chars(text.data() + 1, end, byte, 16);
  return read.ec == std::errc() && read.ptr == end && byte >= 0 ? byte : -1;
}

// What is no escape stays as it is: "100%" is "100%".
std::string decoded(std::string_view text, bool plus_is_blank) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (const auto byte = escaped_byte(text.substr(i)); byte >= 0) {
      result += static_cast<char>(byte);
      i += 2;
    } else {
      result += plus_is_blank && text[i] == '+' ? ' ' : text[i];
    }
  return result;
}

} // namespace

// The query stays encoded, as its parts are split before they are decoded.
void set_target(ReceivedRequest& request, std::string_view target) {
  const auto mark = std::min(target.find('?'), target.size());
  request.path = decoded(target.substr(0, mark), false);
  request.query = target.substr(std::min(mark + 1, target.size()));
}

std::string form_decoded(std::string_view text) {
  return decoded(text, true);
}

} // namespace parlour::adapters::http
