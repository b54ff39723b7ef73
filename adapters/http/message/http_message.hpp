// What is sent to a service and what comes back, as data. No network here.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "runtime/base/clock.hpp"

namespace parlour::adapters::http {

// name, as it is sent, whether carrying it out twice does no harm (RFC 9110).
// clang-format off
#define PARLOUR_HTTP_METHODS(X) \
  X(get, "GET", true) \
  X(post, "POST", false) \
  X(put, "PUT", true) \
  X(patch, "PATCH", false) \
  X(remove, "DELETE", true)
// clang-format on

enum class Method : std::uint8_t {
#define X(name, text, harmless) name,
  PARLOUR_HTTP_METHODS(X)
#undef X
};

// "GET".
std::string_view name_of(Method method);
// Such a request may be sent again without asking, unless a rule says
// otherwise.
bool is_idempotent(Method method);

// Names as the rule wrote them; only Content-Type has one spelling.
struct HttpHeader {
  std::string name;
  std::string value;
  // It holds a secret, which no other host may get.
  bool is_secret = false;

  bool operator==(const HttpHeader&) const = default;
};

// Complete: no value of a conversation is put in afterwards.
struct HttpRequest {
  Method method = Method::get;
  std::string address; // absolute, all parts encoded
  std::vector<HttpHeader> headers = {};
  std::string body = {};
  // Carrying it out twice does no harm, so it may be sent again.
  bool may_repeat = true;
  // For all tries together. Zero: as long as the options say.
  Milliseconds timeout{};

  bool operator==(const HttpRequest&) const = default;
};

// Any status is an answer; whether it is a failure the rules say.
struct HttpAnswer {
  int status = 0;
  std::string body = {};
  // How long the service asks to be left alone (Retry-After).
  std::optional<Milliseconds> retry_after = {};
  // Where it redirects to, as an absolute address; empty: nowhere.
  std::string redirect = {};

  bool operator==(const HttpAnswer&) const = default;
};

// Why there is no answer.
struct HttpFailure {
  enum class Kind : std::uint8_t {
    unreachable, // no connection came about
    insecure,    // the certificate or the encryption is not right
    late,        // the time was over
    broken_off,  // the connection ended within the answer
    too_large,   // the answer exceeds its limit
    not_http,    // what came back is no answer in HTTP
    refused      // it was not sent at all: too many wait, the service is out
  };

  Kind kind = Kind::unreachable;
  // The end of a sentence that begins with the host: "cannot be reached". It
  // never contains an address, a header or a body.
  std::string reason;
  // The service may have got the request.
  bool was_sent = false;

  bool operator==(const HttpFailure&) const = default;
};

using TryOutcome = tl::expected<HttpAnswer, HttpFailure>;

} // namespace parlour::adapters::http
