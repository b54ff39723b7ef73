#include "adapters/http/service_options.hpp"

#include <utility>

#include "runtime/base/file_bytes.hpp"
#include "runtime/plugin/folder.hpp"

namespace parlour::adapters::http {

namespace {

constexpr std::size_t max_rules_file = 1 << 20;

// Reads options one after the other; the first mistake counts.
class Reader {
public:
  explicit Reader(const Options& given) : given_(given) {}

  std::string text(const std::string& name) const {
    return option_value(given_, all_, name);
  }
  bool yes(const std::string& name) const {
    return text(name) == "true";
  }
  Milliseconds time(const std::string& name) {
    const auto read = parse_duration(text(name));
    if (!read || *read <= Milliseconds::zero()) {
      wrong(name, "is a time such as 500ms or 5s, and more than nothing");
      return Milliseconds(1);
    }
    return *read;
  }
  template <class Number>
  Number number(const std::string& name, std::int64_t least,
                std::int64_t most) {
    const auto value = parse_number(text(name)).integer_or(-1);
    if (value < least || value > most)
      wrong(name, "is a number from " + std::to_string(least) + " to " +
                      std::to_string(most));
    return static_cast<Number>(value);
  }
  void wrong(const std::string& name, const std::string& what) {
    if (!error_)
      error_ =
          Error{ErrorKind::settings, "the option '" + name + "' " + what, {}};
  }
  const std::optional<Error>& error() const {
    return error_;
  }

private:
  const Options& given_;
  const std::vector<OptionDescription> all_ = service_option_descriptions();
  std::optional<Error> error_;
};

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
  Reader read(options);
  ServiceOptions result;
  auto& client = result.client;
  client.timeout = read.time("timeout");
  client.transfer.connect_timeout = read.time("connect-timeout");
  client.transfer.max_answer =
      read.number<std::size_t>("max-bytes", 1, 64 << 20);
  client.connections = read.number<std::size_t>("connections", 1, 100);
  client.queue = read.number<std::size_t>("queue", 0, 10'000);
  client.exchange.retry.retries = read.number<unsigned>("retries", 0, 10);
  client.exchange.redirects = read.number<unsigned>("redirects", 0, 10);
  client.breaker.failures = read.number<unsigned>("failures", 0, 1'000);
  client.breaker.pause = read.time("pause");
  client.transfer.proxy = read.text("proxy");
  result.listener.listen = read.text("listen");
  result.listener.token = read.text("token");
  result.listener.max_body = client.transfer.max_answer;
  result.samples = read.yes("samples");
  result.one_by_one = read.yes("one-by-one");
  if (const auto ca = read.text("ca"); !ca.empty()) {
    const auto path = inside(application_folder, ca, "ca");
    if (!path)
      return tl::make_unexpected(path.error());
    if (const auto is = check_is_file(*path); !is)
      return tl::make_unexpected(is.error());
    client.transfer.authority = *path;
  }
  if (read.error())
    return tl::make_unexpected(*read.error());
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

tl::expected<ReadRules, std::vector<Error>>
load_service_rules(const Options& options,
                   const std::string& application_folder,
                   const Environment& environment) {
  using Errors = std::vector<Error>;
  const Reader read(options);
  const auto path = inside(application_folder, read.text("rules"), "rules");
  if (!path)
    return tl::make_unexpected(Errors{path.error()});
  const auto text = read_file(*path, max_rules_file);
  if (!text)
    return tl::make_unexpected(Errors{text.error()});
  return read_service_rules(*text, path->string(), environment,
                            read.text("address"));
}

} // namespace parlour::adapters::http
