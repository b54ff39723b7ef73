// Reads <on>, <otherwise> and <sample> of a command's or a webhook's rules.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "adapters/http/rules/rules_xml.hpp"
#include "adapters/http/rules/service_rules.hpp"
#include "runtime/message/roles.hpp"

namespace parlour::adapters::http {

// Used while one element is read.
class AnswerRuleReader {
public:
  // A webhook has no status, and its events come unasked, so they need not end
  // a request.
  enum class Of : std::uint8_t { command, webhook };

  // `role` is null if the service has none.
  AnswerRuleReader(RulesXml& xml, const Role* role, Of of)
      : xml_(xml), role_(role), of_(of) {}

  // Adds the rule of <on> or <otherwise>. Mistakes are reported.
  void read(const pugi::xml_node& node,
            const std::vector<std::string>& parameters,
            std::vector<AnswerRule>& answers);
  void read_sample(const pugi::xml_node& node,
                   std::vector<SampleRule>& samples);

private:
  void read_conditions(const pugi::xml_node& node, AnswerRule& rule);
  void read_event(const pugi::xml_node& node, EventRule& event,
                  const TemplateNames& names);
  void check_event(const pugi::xml_node& node, const EventRule& event);

  RulesXml& xml_;
  const Role* role_;
  const Of of_;
};

} // namespace parlour::adapters::http
