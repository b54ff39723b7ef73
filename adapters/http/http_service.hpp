// The plug-in HTTPService: an outside service that speaks HTTP. A file of rules
// says which request each command becomes and which event each answer
// (docs/services.md), so a service needs no code.
//
// The roles, commands and events of a component are those of its rules:
// describe_by_rules() fills them in. A command that fails is answered with the
// role's refusal, or with Failed(reason). No reason contains a secret.
//
// What the service reports by itself, by webhooks, becomes events that answer
// nobody: conversations subscribe to them.
//
// Threads: an HttpClient asks the service on a thread of its own, and the
// answers are fired from there; webhooks are heard on another one. The thread
// that calls the plug-in waits only with the option `one-by-one`, which virtual
// time needs.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "adapters/http/server/received_request.hpp"
#include "adapters/http/service_options.hpp"
#include "runtime/plugin/open_messages.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters::http {

// `rules_` is set by on_start() and not changed any more, so the threads of the
// client and of the listener read it without a lock.
class HTTPService : public IPlugin {
public:
  // `environment` gives the values of ${NAME} in the rules.
  explicit HTTPService(Environment environment);
  ~HTTPService() override;

  // Ends what is under way; each command is answered.
  void stop() override;

protected:
  Expected<void> on_start(const Options& options) override;
  void on_message(const Message& message) override;

private:
  Expected<void> listen(ListenerOptions options);
  int take_webhook(const ReceivedRequest& request);
  void ask(const CommandRule& rule, const Message& message,
           HttpRequest request);
  void tell_sample(const CommandRule& rule, const Message& message);
  void tell(const CommandRule& rule, const Message& message,
            const HttpAnswer& answer);
  void tell_failure(const CommandRule& rule, const Message& message,
                    const HttpFailure& failure);
  void refuse(const Message& message, const std::string& reason);

  const Environment environment_;
  ServiceRules rules_;
  bool samples_ = false;
  bool one_by_one_ = false;
  OpenMessages open_;
  // The last members: they still fire events while they are destroyed.
  std::unique_ptr<WebhookListener> listener_;
  std::unique_ptr<HttpClient> client_;
};

PluginFactory http_service_factory();

// The plug-in's description as the rules complete it. If they cannot be read,
// `description` stays as it is.
void describe_by_rules(PluginDescription& description, const Options& options,
                       const std::string& application_folder);

// What `parlour check` reports. Variables that the environment lacks are
// warnings: they may be there where the application runs.
// Each with its file and line.
struct ServiceMistakes {
  std::vector<Error> errors;
  std::vector<Error> missing;
};
ServiceMistakes check_service(const Options& options,
                              const std::string& application_folder);

} // namespace parlour::adapters::http
