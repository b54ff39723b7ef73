// From a service's answer to the event that the rules make of it.
#pragma once

#include <string>

#include "adapters/http/rules/service_rules.hpp"
#include "runtime/base/value.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters::http {

// Why an answer becomes no event.
// Who asked is told the reason; for a webhook, none_applies decides what is
// logged.
struct NoEvent {
  // A sentence. It quotes nothing of the answer.
  std::string reason;
  // No rule applies; else one does, and the answer lacks something.
  bool none_applies = false;
};

// The event of the first rule that applies. `subject` begins the reason if
// there is none: "api.example.com answered".
tl::expected<Answer, NoEvent> read_answer(const std::vector<AnswerRule>& rules,
                                          const std::string& file,
                                          const std::string& subject,
                                          const HttpAnswer& answer,
                                          const List& parameters);

// The sample that stands for the answer: the first for one of the parameters,
// else the first for all; null if there is none.
// <sample for="Boston"> is for a command with a parameter "Boston".
const SampleRule* find_sample(const CommandRule& command,
                              const List& parameters);

} // namespace parlour::adapters::http
