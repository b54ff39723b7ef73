#include "adapters/mqtt/mqtt_options.hpp"

#include <utility>

#include "runtime/base/file_bytes.hpp"
#include "runtime/plugin/folder.hpp"

namespace parlour::adapters::mqtt {

namespace {

namespace fs = std::filesystem;
using Tls = ServerOptions::Tls;

constexpr int plain_port = 1'883;
constexpr int tls_port = 8'883;
// What the protocol's two bytes and the library allow.
constexpr Milliseconds shortest_keep_alive{5'000};
constexpr Milliseconds longest_keep_alive{65'535'000};

tl::unexpected<Error> wrong(const std::string& option,
                            const std::string& what) {
  return fail(ErrorKind::settings, "option '" + option + "' " + what);
}

class Reader {
public:
  Reader(const Options& options, fs::path folder)
      : options_(options), folder_(std::move(folder)) {}

  std::string text(const char* name) const {
    return option_value(options_, mqtt_option_descriptions(), name);
  }
  // check() has seen that it is one.
  Milliseconds duration(const char* name) const {
    return parse_duration(text(name)).value_or(Milliseconds(0));
  }

  Expected<void> check() const {
    for (const auto& option : mqtt_option_descriptions())
      if (auto fits = check_option(option, text(option.name.c_str())); !fits)
        return fits;
    return {};
  }

  // A certificate without its key, or the other way round, is a mistake.
  Expected<void> read_tls(ServerOptions& made) const {
    const auto said = text("tls");
    made.tls_ca = file("tls-ca");
    made.tls_certificate = file("tls-certificate");
    made.tls_key = file("tls-key");
    const bool meant = text("port") == std::to_string(tls_port) ||
                       !made.tls_ca.empty() || !made.tls_certificate.empty();
    made.tls = said == "encrypt"                             ? Tls::encrypt
               : said == "verify" || (said.empty() && meant) ? Tls::verify
                                                             : Tls::off;
    if (made.tls_certificate.empty() != made.tls_key.empty())
      return wrong("tls-certificate", "and 'tls-key' go together");
    // So the library wants it.
    if (!made.tls_certificate.empty() && made.tls_ca.empty())
      return wrong("tls-certificate", "needs 'tls-ca' as well");
    for (const auto* each :
         {&made.tls_ca, &made.tls_certificate, &made.tls_key})
      if (!each->empty())
        if (const auto bytes = read_file(*each); !bytes)
          return wrong("tls-ca, tls-certificate or tls-key",
                       "names '" + each->string() +
                           "': " + bytes.error().message);
    return {};
  }

  Expected<void> read_port(ServerOptions& made) const {
    const auto said = parse_number(text("port"));
    const auto usual = made.tls == Tls::off ? plain_port : tls_port;
    const auto port = said.integer_or(usual);
    if (port < 1 || port > 65'535)
      return wrong("port", "is a number from 1 to 65535");
    made.port = static_cast<std::uint16_t>(port);
    return {};
  }

  // A password file is read up to its first line break, which editors add.
  Expected<void> read_login(ServerOptions& made) const {
    made.user = text("user");
    made.password = text("password");
    if (const auto name = file("password-file"); !name.empty()) {
      if (!made.password.empty())
        return wrong("password-file", "and 'password' are both there; one is "
                                      "enough");
      const auto bytes = read_file(name);
      if (!bytes)
        return wrong("password-file",
                     "names '" + name.string() + "': " + bytes.error().message);
      made.password = bytes->substr(0, bytes->find_first_of("\r\n"));
    }
    if (!made.password.empty() && made.user.empty())
      return wrong("password", "needs a 'user'");
    return {};
  }

  Expected<void> read_times(MQTTOptions& made) const {
    auto& server = made.server;
    server.keep_alive = duration("keep-alive");
    server.connect_timeout = duration("connect-timeout");
    server.pause = duration("pause");
    made.policy.patience = duration("answer-timeout");
    made.policy.settle = duration("settle");
    if (server.keep_alive < shortest_keep_alive ||
        server.keep_alive > longest_keep_alive)
      return wrong("keep-alive", "is 5s to 65535s");
    if (server.connect_timeout <= Milliseconds(0))
      return wrong("connect-timeout", "is longer than nothing");
    if (server.pause <= Milliseconds(0))
      return wrong("pause", "is longer than nothing");
    return {};
  }

  Expected<void> read_devices(MQTTOptions& made) const {
    made.policy.prefix = text("discovery");
    if (made.policy.prefix.find_first_of("#+") != std::string::npos ||
        made.policy.prefix.ends_with('/'))
      return wrong("discovery", "is the beginning of topics, such as "
                                "homeassistant, without '#', '+' and a '/' at "
                                "the end");
    const auto name = text("devices");
    if (name.empty())
      return {};
    auto path = inside(folder_, name, "devices");
    if (!path)
      return tl::make_unexpected(path.error());
    made.devices = std::move(*path);
    return {};
  }

private:
  fs::path file(const char* name) const {
    const auto said = text(name);
    return said.empty() ? fs::path() : folder_ / said;
  }

  const Options& options_;
  const fs::path folder_;
};

} // namespace

const std::vector<OptionDescription>& mqtt_option_descriptions() {
  using Type = OptionType;
  static const std::vector<OptionDescription> descriptions = {
      {"host", "localhost", "the machine that the MQTT server runs on"},
      {"port", "", "its port; 1883, or 8883 with TLS, where nothing is said",
       false, Type::integer},
      {"user", "", "who connects; nobody where nothing is said"},
      {"password", "", "best as ${NAME}, which the environment fills"},
      {"password-file", "", "a file whose first line is the password"},
      {"client-id", "", "the name of the connection; one that nobody else has"},
      {"discovery", "homeassistant",
       "the beginning of the topics on which devices announce themselves"},
      {"devices", "",
       "how the application calls the devices, a .tsv file of the application"},
      {"tls",
       "",
       "verify, the server's certificate too, holds with port 8883 or a "
       "certificate where nothing is said, else off",
       false,
       Type::choice,
       {"off", "encrypt", "verify"}},
      {"tls-ca", "", "the certificates that the server's must come from"},
      {"tls-certificate", "", "the client's own certificate"},
      {"tls-key", "", "its key"},
      {"keep-alive", "30s",
       "after so much silence it asks whether the server "
       "is there",
       false, Type::duration},
      {"connect-timeout", "10s", "how long connecting may take", false,
       Type::duration},
      {"pause", "1s",
       "the first pause before it connects again; each is twice as long as the "
       "last, up to a minute",
       false, Type::duration},
      {"answer-timeout", "5s", "how long a device may take to obey or answer",
       false, Type::duration},
      {"settle", "500ms",
       "if nothing is announced for so long, all devices are known", false,
       Type::duration},
      {"one-by-one", "false",
       "answers each message before it takes the next: where time is virtual",
       false, Type::boolean}};
  return descriptions;
}

// The first error counts.
Expected<MQTTOptions> read_mqtt_options(const Options& options,
                                        const std::string& application_folder) {
  const Reader reader(options, application_folder);
  if (auto fits = reader.check(); !fits)
    return tl::make_unexpected(fits.error());
  MQTTOptions made;
  made.server.host = reader.text("host");
  made.server.client_id = reader.text("client-id");
  made.one_by_one = reader.text("one-by-one") == "true";
  for (auto&& read :
       {reader.read_tls(made.server), reader.read_port(made.server),
        reader.read_login(made.server), reader.read_times(made),
        reader.read_devices(made)})
    if (!read)
      return tl::make_unexpected(read.error());
  return made;
}

} // namespace parlour::adapters::mqtt
