// A request that a service sends to us, and what is to be answered at once. No
// network here.
#pragma once

#include <string>
#include <string_view>

namespace parlour::adapters::http {

struct WebhookRequest {
  std::string method;
  std::string path;  // decoded, without the query
  std::string query; // as it was sent
  std::string content_type;
  std::string authorization;
  std::string body;
};

// Splits the target of a request ("/sms?token=a%20b") into path and query.
void set_target(WebhookRequest& request, std::string_view target);

// The status by which a request is refused, whatever it says: 405 unless it is
// a POST, 401 if it lacks the token. 0: it is not refused. The token stands in
// "Authorization: Bearer TOKEN" or in the query as "token=TOKEN"; an empty one
// is not asked for. The time to compare says nothing about the token.
int refusal_of(const WebhookRequest& request, std::string_view token);

// The body as rules read it: the fields of a form become an object in JSON.
std::string readable_body(const WebhookRequest& request);

// "a=b&c=d+e%21" decoded: "%XX" is a byte, "+" a blank.
std::string form_decoded(std::string_view text);

} // namespace parlour::adapters::http
