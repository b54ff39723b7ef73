#include "adapters/mqtt/mqtt_options.hpp"

#include <utility>

#include "runtime/base/outside/file_bytes.hpp"
#include "runtime/plugin/option_reader.hpp"

namespace parlour::adapters::mqtt {

namespace {

namespace fs = std::filesystem;
using Tls = ServerOptions::Tls;

constexpr int plain_port = 1'883;
constexpr int tls_port = 8'883;
// What the protocol's two bytes and the library allow.
constexpr Milliseconds shortest_keep_alive{5'000};
constexpr Milliseconds longest_keep_alive{65'535'000};

// Settings of the server and of what is expected of devices, one group after
// the other.
// All mistakes are collected by the OptionReader and told together.
class Reader {
public:
  Reader(const Options& options, fs::path folder)
      : read_(options, mqtt_option_descriptions()), folder_(std::move(folder)) {
  }

  Expected<MQTTOptions> read() {
    MQTTOptions made;
    made.server.host = read_.text("host");
    made.server.client_id = read_.text("client-id");
    made.one_by_one = read_.truth("one-by-one");
    read_tls(made.server);
    read_port(made.server);
    read_login(made.server);
    read_times(made);
    read_devices(made);
    return read_.outcome().map([&] { return made; });
  }

private:
  // A certificate without its key, or the other way round, is a mistake.
  //
  // Where `tls` says nothing, port 8883 or a certificate means that the server
  // is to be verified.
  void read_tls(ServerOptions& made) {
    const auto said = read_.text("tls");
    made.tls_ca = file("tls-ca");
    made.tls_certificate = file("tls-certificate");
    made.tls_key = file("tls-key");
    const bool meant = read_.text("port") == std::to_string(tls_port) ||
                       !made.tls_ca.empty() || !made.tls_certificate.empty();
    made.tls = said == "encrypt"                             ? Tls::encrypt
               : said == "verify" || (said.empty() && meant) ? Tls::verify
                                                             : Tls::off;
    if (made.tls_certificate.empty() != made.tls_key.empty())
      read_.wrong("tls-certificate", "and 'tls-key' go together");
    // So the library wants it.
    if (!made.tls_certificate.empty() && made.tls_ca.empty())
      read_.wrong("tls-certificate", "needs 'tls-ca' as well");
    for (const auto* name : {"tls-ca", "tls-certificate", "tls-key"})
      if (const auto path = file(name); !path.empty())
        if (const auto bytes = read_file(path); !bytes)
          read_.wrong(name, "names '" + path.string() +
                                "': " + bytes.error().message);
  }

  void read_port(ServerOptions& made) {
    const auto usual = made.tls == Tls::off ? plain_port : tls_port;
    const auto port =
        read_.has("port") ? read_.integer("port", 1, 65'535) : usual;
    made.port = static_cast<std::uint16_t>(port);
  }

  // A password file is read up to its first line break, which editors add.
  void read_login(ServerOptions& made) {
    made.user = read_.text("user");
    made.password = read_.text("password");
    if (const auto name = file("password-file"); !name.empty()) {
      if (!made.password.empty())
        return read_.wrong("password-file",
                           "and 'password' are both there; one is enough");
      const auto bytes = read_file(name);
      if (!bytes)
        return read_.wrong("password-file", "names '" + name.string() +
                                                "': " + bytes.error().message);
      made.password = bytes->substr(0, bytes->find_first_of("\r\n"));
    }
    if (!made.password.empty() && made.user.empty())
      read_.wrong("password", "needs a 'user'");
  }

  void read_times(MQTTOptions& made) {
    constexpr Milliseconds shortest{1};
    auto& server = made.server;
    server.keep_alive =
        read_.duration("keep-alive", shortest_keep_alive, longest_keep_alive);
    server.connect_timeout = read_.duration("connect-timeout", shortest);
    server.pause = read_.duration("pause", shortest);
    made.policy.patience = read_.duration("answer-timeout");
    made.policy.settle = read_.duration("settle");
  }

  void read_devices(MQTTOptions& made) {
    made.policy.prefix = read_.text("discovery");
    if (made.policy.prefix.find_first_of("#+") != std::string::npos ||
        made.policy.prefix.ends_with('/'))
      read_.wrong("discovery", "is the beginning of topics, such as "
                               "homeassistant, without '#', '+' and a '/' at "
                               "the end");
    made.devices = read_.file("devices", folder_);
  }

  // It may lie outside of the folder.
  fs::path file(const char* name) const {
    const auto said = read_.text(name);
    return said.empty() ? fs::path() : folder_ / said;
  }

  OptionReader read_;
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

Expected<MQTTOptions> read_mqtt_options(const Options& options,
                                        const std::string& application_folder) {
  return Reader(options, application_folder).read();
}

} // namespace parlour::adapters::mqtt
