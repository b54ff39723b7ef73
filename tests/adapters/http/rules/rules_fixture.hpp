// Rules for the tests, read from XML.
#pragma once

#include <gmock/gmock.h>

#include "adapters/http/rules/rules_reader.hpp"

namespace parlour::adapters::http {

inline Environment test_environment() {
  return [](const std::string& name) -> std::string {
    return name == "KEY" ? "geheim/1" : name == "HOST" ? "http://a.com" : "";
  };
}

// The rules in one <service> with an address.
inline ServiceRules rules_of(const std::string& commands,
                             const std::string& role = "") {
  const auto attribute = role.empty() ? "" : " role='" + role + "'";
  auto read = read_service_rules("<service address='http://a.com'" + attribute +
                                     ">" + commands + "</service>",
                                 "a.xml", test_environment());
  if (!read) {
    for (const auto& error : read.error())
      ADD_FAILURE() << to_string(error);
    return {};
  }
  return std::move(read->rules);
}

// One command "Do" with these parameters and this request.
inline ServiceRules request_rules(const std::string& params,
                                  const std::string& request) {
  return rules_of("<command name='Do' params='" + params + "'>" + request +
                  "<on><event name='Done'/></on></command>");
}

} // namespace parlour::adapters::http
