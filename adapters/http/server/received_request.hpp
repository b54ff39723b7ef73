// A request that somebody sends to us, as data. No network here.
#pragma once

#include <string>
#include <string_view>

namespace parlour::adapters::http {

struct ReceivedRequest {
  std::string method;
  std::string path;  // decoded, without the query
  std::string query; // as it was sent
  std::string content_type;
  std::string authorization;
  std::string body;
};

// Splits the target of a request ("/sms?token=a%20b") into path and query.
void set_target(ReceivedRequest& request, std::string_view target);

// "a=b&c=d+e%21" decoded: "%XX" is a byte, "+" a blank.
std::string form_decoded(std::string_view text);

} // namespace parlour::adapters::http
