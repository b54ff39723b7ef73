#include "adapters/http/policy/redirect_policy.hpp"

#include <utility>

#include "adapters/http/message/http_address.hpp"

namespace parlour::adapters::http {

namespace {

using Unexpected = tl::unexpected<std::string>;

// The headers that say what the body is go with the body.
bool is_about_body(const HttpHeader& header) {
  return header.name == "Content-Type";
}

HttpRequest as_get(HttpRequest request) {
  request.method = Method::get;
  request.body.clear();
  request.may_repeat = true;
  std::erase_if(request.headers, is_about_body);
  return request;
}

} // namespace

bool is_redirect(const HttpAnswer& answer) {
  switch (answer.status) {
  case 301:
  case 302:
  case 303:
  case 307:
  case 308:
    return !answer.redirect.empty();
  default:
    return false;
  }
}

// From https to http everybody could read the values, so the scheme stays.
tl::expected<HttpRequest, std::string> redirected(const HttpRequest& request,
                                                  const HttpAnswer& answer) {
  const auto from = read_address(request.address);
  const auto to = read_address(answer.redirect);
  if (!from || !to)
    return Unexpected("redirects to an address that cannot be used");
  if (from->scheme != to->scheme)
    return Unexpected("redirects from " + from->scheme + " to " + to->scheme +
                      "; write the address with " + to->scheme +
                      ":// if that is meant");
  const bool keeps = answer.status == 307 || answer.status == 308;
  auto next =
      keeps || request.method == Method::get ? request : as_get(request);
  next.address = answer.redirect;
  if (from->same_origin(*to))
    return next;
  if (request.method != Method::get)
    return Unexpected("redirects to another server, " + to->server() +
                      ", which only a GET follows; write that address if it "
                      "is meant");
  std::erase_if(next.headers, [](const auto& one) { return one.is_secret; });
  return next;
}

} // namespace parlour::adapters::http
