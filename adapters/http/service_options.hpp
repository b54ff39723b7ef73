// The options of an HTTPService.
#pragma once

#include <string>
#include <vector>

#include "adapters/http/rules/rules_reader.hpp"
#include "adapters/http/transfer/http_client.hpp"
#include "adapters/http/webhooks/webhook_listener.hpp"
#include "runtime/plugin/options.hpp"

namespace parlour::adapters::http {

// All options of docs/services.md but the rules themselves.
struct ServiceOptions {
  ClientOptions client;
  ListenerOptions listener;
  // Answers come from the samples of the rules; nobody is asked.
  bool samples = false;
  // Each message is answered before the next one is taken.
  bool one_by_one = false;
};

std::vector<OptionDescription> service_option_descriptions();

// Reads all options but the rules. An error of kind Settings says what a value
// has to be.
Expected<ServiceOptions>
read_service_options(const Options& options,
                     const std::string& application_folder);

// Whether the options say where the webhooks of the rules are heard. Samples
// need none.
Expected<void> check_webhooks(const ServiceOptions& options,
                              const ServiceRules& rules);

// Reads the file of rules that the options name, or returns all errors.
tl::expected<ReadRules, std::vector<Error>>
load_service_rules(const Options& options,
                   const std::string& application_folder,
                   const Environment& environment);

} // namespace parlour::adapters::http
