// Reads the rules of a service from XML (docs/services.md), and checks them as
// far as that is possible without the service: against the role, and against
// the samples that they give themselves.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "adapters/http/rules/service_rules.hpp"

namespace parlour::adapters::http {

struct ReadRules {
  ServiceRules rules;
  // Variables that the environment lacks, each with the place that needs it.
  // The rules have empty texts there.
  std::vector<Error> missing;
};

// `address` is the beginning of addresses that begin with "/"; empty: what
// <service> says. Returns all errors, each with its line in `file`, if there
// are any. No error contains a value of the environment.
tl::expected<ReadRules, std::vector<Error>>
read_service_rules(std::string_view text, const std::string& file,
                   const Environment& environment,
                   const std::string& address = "");

} // namespace parlour::adapters::http
