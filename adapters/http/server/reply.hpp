// What a received request is answered with, as data.
#pragma once

#include <string>
#include <string_view>

namespace parlour::adapters::http {

struct Reply {
  int status = 204;
  std::string text = {};
  std::string content_type = {}; // of the text; empty: there is none
  // Further headers, each with its end of a line: "Allow: POST\r\n".
  std::string headers = {};
  // Only the length of the text is told, as to HEAD.
  bool without_text = false;
};

// The reply as it is sent, in HTTP/1.1. The connection ends with it.
std::string bytes_of(const Reply& reply);

// "Not Found" for 404, for people who look at the traffic: programs read the
// number. "Status" for one that we never answer with.
std::string_view words_for(int status);

} // namespace parlour::adapters::http
