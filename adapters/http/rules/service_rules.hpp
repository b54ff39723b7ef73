// The rules of one service as data: which request each command becomes, and
// which event each answer. docs/services.md has the notation.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "adapters/http/message/http_message.hpp"
#include "adapters/http/rules/text_template.hpp"
#include "runtime/base/error.hpp"
#include "runtime/message/roles.hpp"
#include "runtime/plugin/parameters.hpp"

namespace re2 {
class RE2;
}

namespace parlour::adapters::http {

// What a body is, and so how values in it are written.
// name, Content-Type
// clang-format off
#define PARLOUR_BODY_TYPES(X) \
  X(json, "application/json") \
  X(xml, "application/xml; charset=utf-8") \
  X(text, "text/plain; charset=utf-8")
// clang-format on

enum class BodyType : std::uint8_t {
#define X(name, content_type) name,
  PARLOUR_BODY_TYPES(X)
#undef X
};

struct NamedTemplate {
  std::string name;
  TextTemplate value;
};

// One <get>, <post> and so on. Templates are filled anew for each command.
struct RequestRule {
  Method method = Method::get;
  // The whole address without what <query> adds.
  TextTemplate address;
  // "api.example.com": how messages name the service. Empty if the environment
  // lacks a part of it.
  std::string server;
  std::vector<NamedTemplate> queries;
  std::vector<NamedTemplate> headers;
  // Of a form.
  std::vector<NamedTemplate> fields;
  std::optional<BodyType> body_type;
  TextTemplate body;
  // Zero: what the component's options say.
  Milliseconds timeout{};
  bool may_repeat = true;
};

struct ParamRule {
  TextTemplate value;
  // If the answer lacks what the value names.
  std::optional<std::string> otherwise;
  std::uint32_t line = 0;
};

struct EventRule {
  std::string name;
  std::vector<ParamRule> params;
};

// An answer to which all of these apply becomes the event.
// One <on> or <otherwise>; the event's parameters are templates over the
// answer.
struct AnswerRule {
  // Ranges of statuses, both ends included; empty: any.
  std::vector<std::pair<int, int>> statuses;
  // The expression that the text must match, anywhere; null: any.
  std::shared_ptr<const re2::RE2> matches;
  // The JSON must have this, and it must not be null.
  std::optional<JsonPath> has;
  // It must be this text.
  std::optional<std::string> is;
  EventRule event;
  std::uint32_t line = 0;
};

// What the service would answer: for the check and for tests.
struct SampleRule {
  HttpAnswer answer;
  // If a parameter is this text; nothing: always.
  std::optional<std::string> whom;
  std::uint32_t line = 0;
};

// One <command> of the file.
struct CommandRule {
  std::string name;
  std::vector<Parameter> parameters;
  RequestRule request;
  // The first that applies counts.
  std::vector<AnswerRule> answers;
  std::vector<SampleRule> samples;

  // "api.example.com answered": how messages begin.
  std::string who_answered() const;
};

// What the service reports by itself, as a POST to this path.
struct WebhookRule {
  std::string path; // "/sms"
  std::vector<AnswerRule> answers;
  std::vector<SampleRule> samples;
};

// Never changed once they are read; any thread may use them.
struct ServiceRules {
  std::string file; // for messages
  std::string role; // empty: none
  std::vector<CommandRule> commands;
  std::vector<WebhookRule> webhooks;

  // Null if the service does not know the command.
  const CommandRule* find(std::string_view command) const;
  // Null if nothing is reported there.
  const WebhookRule* find_webhook(std::string_view path) const;
  // The event that says no, with one parameter, the reason: the role's own, or
  // Failed.
  std::string refusal() const;
};

// Commands and events beyond those of the role, for the description. An event
// that only a webhook has ends no request.
std::vector<RoleCommand> own_commands(const ServiceRules& rules);
std::vector<RoleEvent> own_events(const ServiceRules& rules);

} // namespace parlour::adapters::http
