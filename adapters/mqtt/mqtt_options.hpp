// The options of MQTTDevices. docs/devices.md explains each for users.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "adapters/mqtt/device_policy.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters::mqtt {

// How the server is reached.
struct ServerOptions {
  enum class Tls : std::uint8_t {
    off,
    encrypt, // accepts any certificate
    verify,  // checks the server's certificate and name
  };

  std::string host;
  std::uint16_t port = 0;
  std::string user; // empty: none
  std::string password;
  std::string client_id; // empty: the server chooses one
  Tls tls = Tls::off;
  // Files in PEM. An empty CA: those that the machine trusts.
  std::filesystem::path tls_ca;
  std::filesystem::path tls_certificate;
  std::filesystem::path tls_key;
  Milliseconds keep_alive{};
  Milliseconds connect_timeout{};
  // The first pause after a connection that failed.
  Milliseconds pause{};
};

struct MQTTOptions {
  ServerOptions server;
  PolicySettings policy;
  // The application's list of devices; empty: none.
  std::filesystem::path devices;
  // Answer each message before the next one is taken.
  bool one_by_one = false;
};

const std::vector<OptionDescription>& mqtt_option_descriptions();

// The files of passwords and certificates may lie outside of the application's
// folder. An error has the kind Settings and names the option, never a secret.
Expected<MQTTOptions> read_mqtt_options(const Options& options,
                                        const std::string& application_folder);

} // namespace parlour::adapters::mqtt
