#include "adapters/http/server/reply.hpp"

namespace parlour::adapters::http {

std::string_view words_for(int status) {
  switch (status) {
  case 200:
    return "OK";
  case 204:
    return "No Content";
  case 400:
    return "Bad Request";
  case 401:
    return "Unauthorized";
  case 404:
    return "Not Found";
  case 405:
    return "Method Not Allowed";
  case 413:
    return "Content Too Large";
  case 422:
    return "Unprocessable Content";
  case 429:
    return "Too Many Requests";
  case 431:
    return "Request Header Fields Too Large";
  case 500:
    return "Internal Server Error";
  case 503:
    return "Service Unavailable";
  default:
    return "Status";
  }
}

// 204 has no text, nor a length of it.
std::string bytes_of(const Reply& reply) {
  auto text = "HTTP/1.1 " + std::to_string(reply.status) + ' ' +
              std::string(words_for(reply.status)) + "\r\n" + reply.headers;
  if (!reply.content_type.empty())
    text += "Content-Type: " + reply.content_type + "\r\n";
  if (reply.status != 204)
    text += "Content-Length: " + std::to_string(reply.text.size()) + "\r\n";
  text += "Connection: close\r\n\r\n";
  if (!reply.without_text)
    text += reply.text;
  return text;
}

} // namespace parlour::adapters::http
