// The options of MySQLDatabase. docs/databases.md explains each for users.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "adapters/database/database_options.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

struct MariaDBOptions : DatabaseOptions {
  enum class Tls : std::uint8_t {
    off,
    encrypt, // accepts any certificate
    verify,  // checks the server's certificate and name
  };

  std::string host;
  // Unix socket and port of the server. Empty and 0: the library's defaults.
  std::string socket;
  unsigned port = 0;
  // Empty: the account that runs the program.
  std::string user;
  std::string password;
  std::string database;
  Tls tls = Tls::off;
  // Files in PEM. An empty CA: those that the machine trusts.
  std::filesystem::path tls_ca;
  std::filesystem::path tls_certificate;
  std::filesystem::path tls_key;
  // Create a database of its own from schema and seed, and drop it at the end.
  bool copy = false;
  // Answer each message before the next one is taken.
  bool one_by_one = false;
  // The largest number of connections at a time.
  std::size_t connections = 4;
  Milliseconds connect_timeout{5'000};
  Milliseconds query_timeout{5'000};
  // How many prepared statements each connection keeps.
  std::size_t statements = 64;
};

const std::vector<OptionDescription>& mariadb_option_descriptions();

// Reads the options. Password files and certificates may lie outside of the
// application's folder. An error has the kind Settings and names the option,
// never the value of a secret.
Expected<MariaDBOptions>
read_mariadb_options(const Options& options,
                     const std::string& application_folder);

} // namespace parlour::adapters
