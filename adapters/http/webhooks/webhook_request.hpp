// What is looked at in the report of a service. No network here.
#pragma once

#include <string>
#include <string_view>

#include "adapters/http/server/received_request.hpp"

namespace parlour::adapters::http {

// The status by which a request is refused, whatever it says: 405 unless it is
// a POST, 401 if it lacks the token. 0: it is not refused. The token stands in
// "Authorization: Bearer TOKEN" or in the query as "token=TOKEN"; an empty one
// is not asked for. The time to compare says nothing about the token.
int refusal_of(const ReceivedRequest& request, std::string_view token);

// The body as rules read it: the fields of a form become an object in JSON.
std::string readable_body(const ReceivedRequest& request);

} // namespace parlour::adapters::http
