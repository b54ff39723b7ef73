// From a command to the request that its rule describes. Values are written as
// the place demands: encoded in addresses and forms, as JSON in JSON, without
// line ends in headers.
#pragma once

#include <string>

#include <tl/expected.hpp>

#include "adapters/http/rules/service_rules.hpp"
#include "runtime/base/value.hpp"

namespace parlour::adapters::http {

// `request_id` stands for {request.id}; the caller makes one for each command.
// The error is a sentence: a parameter is missing, or cannot stand where the
// rule has it.
tl::expected<HttpRequest, std::string>
make_request(const CommandRule& rule, const List& parameters,
             const std::string& request_id);

// The largest address and body that are sent, in bytes.
// Servers commonly refuse longer addresses.
inline constexpr std::size_t max_address = 8 << 10;
inline constexpr std::size_t max_body = 1 << 20;

} // namespace parlour::adapters::http
