#include "adapters/http/http_service.hpp"

#include <cstdlib>
#include <random>
#include <string_view>
#include <utility>

#include "adapters/http/rules/answer_reader.hpp"
#include "adapters/http/rules/request_maker.hpp"
#include "adapters/http/webhooks/webhook_request.hpp"

namespace parlour::adapters::http {

namespace {

// Joins errors to one with a line for each.
Error joined(const std::vector<Error>& errors) {
  auto all = errors.front();
  for (std::size_t at = 1; at < errors.size(); ++at)
    all.message += '\n' + to_string(errors[at]);
  return all;
}

// A variable that is not set counts as empty.
std::string environment_value(const std::string& name) {
  const auto* value = std::getenv(name.c_str());
  return value ? value : "";
}

// A text of its own for each command: nobody else can guess it.
std::string new_request_id() {
  constexpr std::string_view digits = "0123456789abcdef";
  std::random_device random;
  std::string id;
  for (int i = 0; i < 32; ++i)
    id += digits[random() % digits.size()];
  return id;
}

} // namespace

HTTPService::HTTPService(Environment environment)
    : environment_(std::move(environment)) {}

HTTPService::~HTTPService() = default;

// With samples nobody is asked: variables that the environment lacks do no harm
// then, and no webhook is heard.
Expected<void> HTTPService::on_start(const Options& options) {
  const auto folder = host().application_folder();
  auto settings = read_service_options(options, folder);
  if (!settings)
    return tl::make_unexpected(settings.error());
  auto read = load_service_rules(options, folder, environment_);
  if (!read)
    return tl::make_unexpected(joined(read.error()));
  if (auto heard = check_webhooks(*settings, read->rules); !heard)
    return heard;
  samples_ = settings->samples;
  one_by_one_ = settings->one_by_one;
  rules_ = std::move(read->rules);
  if (samples_)
    return {};
  if (!read->missing.empty())
    return tl::make_unexpected(joined(read->missing));
  auto client = HttpClient::start(
      std::move(settings->client),
      [this](const std::string& what) { host().failed(what); });
  if (!client)
    return tl::make_unexpected(client.error());
  client_ = std::move(*client);
  return listen(std::move(settings->listener));
}

// Virtual time hears nothing from outside, as nothing outside waits for it.
Expected<void> HTTPService::listen(ListenerOptions options) {
  if (rules_.webhooks.empty() || one_by_one_)
    return {};
  auto listener = WebhookListener::start(
      std::move(options),
      [this](const ReceivedRequest& request) { return take_webhook(request); },
      [this](const std::string& what) { host().failed(what); });
  if (!listener)
    return tl::make_unexpected(listener.error());
  listener_ = std::move(*listener);
  host().log("webhooks are heard at " + listener_->address());
  return {};
}

void HTTPService::stop() {
  listener_.reset();
  client_.reset();
}

// The request is made also where a sample answers, so that a test finds what a
// command lacks.
void HTTPService::on_message(const Message& message) {
  const auto* rule = rules_.find(message.command);
  if (!rule)
    return refuse(message,
                  "The service has no command '" + message.command + "'.");
  auto request = make_request(*rule, message.params, new_request_id());
  if (!request)
    return refuse(message, request.error());
  if (samples_)
    return tell_sample(*rule, message);
  if (!client_)
    return refuse(message, "The component has ended.");
  ask(*rule, without_its_way(message), std::move(*request));
}

// On the listener's thread. 204: it has become an event; 404 and 422: the rules
// know nothing of it.
int HTTPService::take_webhook(const ReceivedRequest& request) {
  const auto* rule = rules_.find_webhook(request.path);
  if (!rule)
    return 404;
  auto event = read_answer(rule->answers, rules_.file,
                           "A report to " + rule->path + " came",
                           {200, readable_body(request)}, {});
  if (!event) {
    host().log(event.error().none_applies
                   ? "No rule applies to a report to " + rule->path + "."
                   : event.error().reason);
    return 422;
  }
  answer({}, std::move(event->command), std::move(event->params));
  return 204;
}

// The rules live as long as the client, which is destroyed first.
void HTTPService::ask(const CommandRule& rule, const Message& message,
                      HttpRequest request) {
  open_.open();
  client_->submit(std::move(request),
                  [this, &rule, message](const TryOutcome& outcome) {
                    const OpenMessages::Closing closing(open_);
                    if (outcome)
                      tell(rule, message, *outcome);
                    else
                      tell_failure(rule, message, outcome.error());
                  });
  if (one_by_one_)
    open_.wait_for_all();
}

void HTTPService::tell_sample(const CommandRule& rule, const Message& message) {
  if (const auto* sample = find_sample(rule, message.params))
    return tell(rule, message, sample->answer);
  refuse(message, "The rules have no <sample> of an answer to " + rule.name +
                      ", and no service is asked here.");
}

// An answer that no rule fits is the role's refusal.
void HTTPService::tell(const CommandRule& rule, const Message& message,
                       const HttpAnswer& received) {
  auto event = read_answer(rule.answers, rules_.file, rule.who_answered(),
                           received, message.params);
  if (event)
    return answer(message, std::move(event->command), std::move(event->params));
  refuse(message, event.error().reason);
}

// Who must not repeat a request wants to know whether it was carried out.
void HTTPService::tell_failure(const CommandRule& rule, const Message& message,
                               const HttpFailure& failure) {
  const bool is_in_doubt = failure.was_sent && !rule.request.may_repeat;
  refuse(message,
         rule.request.server + " " + failure.reason +
             (is_in_doubt ? "; whether it has carried out the request is not "
                            "known."
                          : "."));
}

void HTTPService::refuse(const Message& message, const std::string& reason) {
  answer(message, rules_.refusal(), {reason});
}

PluginFactory http_service_factory() {
  PluginDescription description;
  description.name = "HTTPService";
  description.sentence = "a service that speaks HTTP, by a file of rules; it "
                         "fills the role that they name";
  description.options = service_option_descriptions();
  return {std::move(description),
          [] { return std::make_unique<HTTPService>(environment_value); }};
}

void describe_by_rules(PluginDescription& description, const Options& options,
                       const std::string& application_folder) {
  const auto read =
      load_service_rules(options, application_folder, environment_value);
  if (!read)
    return;
  const auto& rules = read->rules;
  if (!rules.role.empty())
    description.roles = {rules.role};
  description.commands = own_commands(rules);
  description.events = own_events(rules);
}

// The options and the rules are read independently, so that mistakes in both
// are told.
ServiceMistakes check_service(const Options& options,
                              const std::string& application_folder) {
  ServiceMistakes mistakes;
  const auto read = read_service_options(options, application_folder);
  if (!read)
    mistakes.errors.push_back(read.error());
  const auto rules =
      load_service_rules(options, application_folder, environment_value);
  if (rules && read)
    if (auto heard = check_webhooks(*read, rules->rules); !heard)
      mistakes.errors.push_back(heard.error());
  if (rules)
    mistakes.missing = rules->missing;
  else
    mistakes.errors.insert(mistakes.errors.end(), rules.error().begin(),
                           rules.error().end());
  return mistakes;
}

} // namespace parlour::adapters::http
