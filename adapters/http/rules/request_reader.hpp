// Reads <get>, <post>, <put>, <patch> and <delete> of a command's rules.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "adapters/http/rules/rules_xml.hpp"
#include "adapters/http/rules/service_rules.hpp"

namespace parlour::adapters::http {

// The method that an element stands for: "get", "delete".
std::optional<Method> method_of_element(std::string_view element);

// The method decides what the request may have, and whether it may be repeated
// unless the rule says it.
class RequestReader {
public:
  // `address`: the beginning of addresses that begin with "/".
  RequestReader(RulesXml& xml, const Environment& environment,
                std::string address, std::vector<Error>& missing)
      : xml_(xml), environment_(environment), address_(std::move(address)),
        missing_(missing) {}

  // Mistakes are reported; the rule is then as complete as possible.
  RequestRule read(const pugi::xml_node& node, Method method,
                   const std::vector<std::string>& parameters);

private:
  void read_terms(const pugi::xml_node& node, RequestRule& rule);
  void read_address(const pugi::xml_node& node, RequestRule& rule);
  std::string with_variables(const pugi::xml_node& node, std::string text,
                             bool& is_whole);
  void read_part(const pugi::xml_node& node, RequestRule& rule);
  void read_header(const pugi::xml_node& node, RequestRule& rule);
  void read_body(const pugi::xml_node& node, RequestRule& rule);
  NamedTemplate named(const pugi::xml_node& node);
  TextTemplate read_text(const pugi::xml_node& node, std::string_view text);

  RulesXml& xml_;
  const Environment& environment_;
  const std::string address_;
  std::vector<Error>& missing_;
  TemplateNames names_;
};

} // namespace parlour::adapters::http
