#include "adapters/http/webhooks/webhook_request.hpp"

#include <cstddef>
#include <functional>
#include <utility>

#include "runtime/text/json_text.hpp"

namespace parlour::adapters::http {

namespace {

constexpr std::string_view bearer = "Bearer ";

// What stands before the separator, or all if there is none. `text` keeps what
// stands behind it.
std::string_view take_until(std::string_view& text, char separator) {
  const auto end = text.find(separator);
  const auto taken = text.substr(0, end);
  text = end == std::string_view::npos ? "" : text.substr(end + 1);
  return taken;
}

// Calls `take` with each name and value of "a=b&c=d", decoded.
void each_pair(std::string_view text,
               const std::function<void(std::string, std::string)>& take) {
  while (!text.empty()) {
    auto value = take_until(text, '&');
    if (value.empty())
      continue;
    auto name = form_decoded(take_until(value, '='));
    take(std::move(name), form_decoded(value));
  }
}

// Looks at every byte, wherever the first difference is.
bool is_same(std::string_view left, std::string_view right) {
  bool differs = left.size() != right.size();
  for (std::size_t i = 0; i < right.size(); ++i)
    differs |= (i < left.size() ? left[i] : '\0') != right[i];
  return !differs;
}

// Services that cannot send headers have the token in the address.
bool has_token(const ReceivedRequest& request, std::string_view token) {
  const std::string_view header = request.authorization;
  if (header.starts_with(bearer) &&
      is_same(header.substr(bearer.size()), token))
    return true;
  bool is_there = false;
  each_pair(request.query, [&](const auto& name, const auto& value) {
    is_there = is_there || (name == "token" && is_same(value, token));
  });
  return is_there;
}

} // namespace

// Who has no token does not learn which methods and paths there are.
int refusal_of(const ReceivedRequest& request, std::string_view token) {
  if (!token.empty() && !has_token(request, token))
    return 401;
  return request.method == "POST" ? 0 : 405;
}

// Some senders call JSON a form. No form begins with a brace: it would be
// encoded.
std::string readable_body(const ReceivedRequest& request) {
  if (!request.content_type.starts_with("application/x-www-form-urlencoded") ||
      request.body.starts_with('{'))
    return request.body;
  Map fields;
  each_pair(request.body, [&](const auto& name, auto value) {
    fields.set(name, Value(std::move(value)));
  });
  return json_text(Value(std::move(fields)));
}

} // namespace parlour::adapters::http
