// Any bytes as a service's file of rules and, behind a zero byte, as what the
// service sends. What is accepted makes requests whose address can be read and
// whose headers have one line, unless the rules name a variable that the
// environment lacks: such a service answers from its samples alone.
#include <cstdlib>
#include <string>
#include <string_view>

#include "adapters/http/message/http_address.hpp"
#include "adapters/http/rules/answer_reader.hpp"
#include "adapters/http/rules/request_maker.hpp"
#include "adapters/http/rules/rules_reader.hpp"
#include "adapters/http/server/request_parser.hpp"
#include "adapters/http/webhooks/webhook_request.hpp"

namespace {

using namespace parlour::adapters::http;
using parlour::List;
using parlour::Value;

// Values that try to leave their place.
List parameters_from(const std::string& bytes) {
  return {Value(bytes), Value("../x\r\nEvil: 1"), Value(), Value(7),
          Value(List{1, bytes})};
}

void check(const HttpRequest& request) {
  if (!request.address.empty() && !read_address(request.address))
    std::abort();
  for (const auto& header : request.headers)
    if (header.value.find_first_of("\r\n") != std::string::npos)
      std::abort();
}

std::string environment(const std::string& name) {
  if (name.ends_with("URL"))
    return "http://127.0.0.1:1";
  return name.ends_with("KEY") || name.ends_with("TOKEN") ? "secret" : "";
}

void ask(const ServiceRules& rules, const List& parameters) {
  for (const auto& command : rules.commands)
    if (const auto request = make_request(command, parameters, "1"))
      check(*request);
}

void answer(const ServiceRules& rules, const List& parameters,
            const std::string& bytes) {
  for (const auto& command : rules.commands) {
    for (const auto status : {200, 404})
      static_cast<void>(read_answer(command.answers, rules.file,
                                    command.who_answered(), {status, bytes},
                                    parameters));
    static_cast<void>(find_sample(command, parameters));
  }
  for (const auto& webhook : rules.webhooks)
    static_cast<void>(
        read_answer(webhook.answers, rules.file, "a report", {200, bytes}, {}));
  static_cast<void>(own_commands(rules));
  static_cast<void>(own_events(rules));
}

// As a report's bytes.
void hear(std::string_view bytes) {
  const auto parser = make_request_parser(1'000);
  if (parser && parser->take(bytes) == 200) {
    const auto request = parser->request();
    static_cast<void>(refusal_of(request, "token"));
    static_cast<void>(readable_body(request));
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  const std::string_view all(reinterpret_cast<const char*>(data), size);
  const auto end = all.find('\0');
  const std::string sent(end == std::string_view::npos ? ""
                                                       : all.substr(end + 1));
  const auto read = read_service_rules(all.substr(0, end), "rules.xml",
                                       environment, "http://127.0.0.1:1/v1");
  const auto parameters = parameters_from(sent);
  if (read && read->missing.empty())
    ask(read->rules, parameters);
  if (read)
    answer(read->rules, parameters, sent);
  hear(sent);
  return 0;
}
