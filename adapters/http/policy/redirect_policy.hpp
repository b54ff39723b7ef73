// What becomes of a request that the service redirects. No network.
#pragma once

#include <string>

#include <tl/expected.hpp>

#include "adapters/http/message/http_message.hpp"

namespace parlour::adapters::http {

// Whether the answer is a redirect that can be followed.
bool is_redirect(const HttpAnswer& answer);

// The request for the address that the answer names. On the same server it
// keeps its headers and, with 307 and 308, its method and its body; else it
// becomes a GET. To another server only a GET goes on, without secrets. The
// scheme never changes. The error is the end of a sentence that begins with the
// host.
tl::expected<HttpRequest, std::string> redirected(const HttpRequest& request,
                                                  const HttpAnswer& answer);

} // namespace parlour::adapters::http
