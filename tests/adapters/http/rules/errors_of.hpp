// The mistakes in a file of rules, each as text with its line.
#pragma once

#include "tests/adapters/http/rules/rules_fixture.hpp"

namespace parlour::adapters::http {

inline std::vector<std::string> errors_of(const std::string& xml,
                                          const std::string& address = "") {
  const auto read =
      read_service_rules(xml, "a.xml", test_environment(), address);
  std::vector<std::string> texts;
  if (!read)
    for (const auto& error : read.error())
      texts.push_back(to_string(error));
  return texts;
}

} // namespace parlour::adapters::http
