#include "adapters/http/service_options.hpp"

#include <utility>

#include "runtime/base/outside/file_bytes.hpp"
#include "runtime/plugin/folder.hpp"
#include "runtime/plugin/option_reader.hpp"

namespace parlour::adapters::http {

namespace {

// In bytes; a file of rules has a few thousand.
constexpr std::size_t max_rules_file = 1 << 20;

constexpr Milliseconds shortest{1};

} // namespace

std::vector<OptionDescription> service_option_descriptions() {
  using Type = OptionType;
  return {
      {"rules", "", "the file of its rules, in the application's folder", true},
      {"address", "", "the service's address, instead of that in the rules"},
      {"timeout", "8s", "the longest time for a request with all its tries",
       false, Type::duration},
      {"connect-timeout", "3s", "the longest time for one connection", false,
       Type::duration},
      {"max-bytes", "1048576", "the most bytes of an answer", false,
       Type::integer},
      {"connections", "8", "the most requests at a time", false, Type::integer},
      {"queue", "100", "the most requests that wait for a connection", false,
       Type::integer},
      {"retries", "2", "how often a request is sent again", false,
       Type::integer},
      {"redirects", "3", "how many redirects are followed", false,
       Type::integer},
      {"failures", "5",
       "after how many failures in a row the service is left alone; 0: never",
       false, Type::integer},
      {"pause", "30s", "for how long it is left alone", false, Type::duration},
      {"ca", "", "certificates to trust instead of the machine's, in PEM"},
      {"proxy", "", "the address of a proxy"},
      {"listen", "", "where webhooks are heard, such as 127.0.0.1:8090"},
      {"token", "", "what a webhook must have; needed off loopback"},
      {"samples", "false", "answers by the samples of the rules; asks nobody",
       false, Type::boolean},
      {"one-by-one", "false", "answers each message before the next", false,
       Type::boolean},
  };
}

Expected<ServiceOptions>
read_service_options(const Options& options,
                     const std::string& application_folder) {
  const auto descriptions = service_option_descriptions();
  OptionReader read(options, descriptions);
  ServiceOptions result;
  auto& client = result.client;
  client.timeout = read.duration("timeout", shortest);
  client.transfer.connect_timeout = read.duration("connect-timeout", shortest);
  client.transfer.max_answer = read.count("max-bytes", 1, 64 << 20);
  client.connections = read.count("connections", 1, 100);
  client.queue = read.count("queue", 0, 10'000);
  client.exchange.retry.retries =
      static_cast<unsigned>(read.integer("retries", 0, 10));
  client.exchange.redirects =
      static_cast<unsigned>(read.integer("redirects", 0, 10));
  client.breaker.failures =
      static_cast<unsigned>(read.integer("failures", 0, 1'000));
  client.breaker.pause = read.duration("pause", shortest);
  client.transfer.proxy = read.text("proxy");
  result.listener.listen = read.text("listen");
  result.listener.token = read.text("token");
  result.listener.max_body = client.transfer.max_answer;
  result.samples = read.truth("samples");
  result.one_by_one = read.truth("one-by-one");
  if (const auto ca = read.file("ca", application_folder); !ca.empty()) {
    if (const auto is = check_is_file(ca); !is)
      read.wrong(is.error());
    client.transfer.authority = ca;
  }
  if (const auto outcome = read.outcome(); !outcome)
    return tl::make_unexpected(outcome.error());
  return result;
}

Expected<void> check_webhooks(const ServiceOptions& options,
                              const ServiceRules& rules) {
  if (rules.webhooks.empty() || options.samples)
    return {};
  if (options.listener.listen.empty())
    return fail(ErrorKind::settings,
                "the rules have a <webhook>; the option 'listen' says where "
                "it is heard, such as 127.0.0.1:8090");
  return check_listener(options.listener);
}

// The file has to be in the application's folder: what is installed elsewhere
// comes along.
tl::expected<ReadRules, std::vector<Error>>
load_service_rules(const Options& options,
                   const std::string& application_folder,
                   const Environment& environment) {
  using Errors = std::vector<Error>;
  const auto descriptions = service_option_descriptions();
  const auto text_of = [&](const char* name) {
    return option_value(options, descriptions, name);
  };
  const auto path = inside(application_folder, text_of("rules"), "rules");
  if (!path)
    return tl::make_unexpected(Errors{path.error()});
  const auto text = read_file(*path, max_rules_file);
  if (!text)
    return tl::make_unexpected(Errors{text.error()});
  return read_service_rules(*text, path->string(), environment,
                            text_of("address"));
}

} // namespace parlour::adapters::http
