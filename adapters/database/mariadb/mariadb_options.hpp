// The settings of a MariaDB database, read once.
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
    encrypt, // whoever it is
    verify,  // and is who the certificate says
  };

  std::string host;
  std::string socket; // empty: the library's own, on this machine
  unsigned port = 0;  // 0: the library's own
  std::string user;   // empty: who runs the program
  std::string password;
  std::string database;
  Tls tls = Tls::off;
  std::filesystem::path tls_ca; // empty: those that the machine trusts
  std::filesystem::path tls_certificate;
  std::filesystem::path tls_key;
  bool copy = false;       // a database of its own, dropped at the end
  bool one_by_one = false; // each message answered before the next
  std::size_t connections = 4;
  Milliseconds connect_timeout{5'000};
  Milliseconds query_timeout{5'000};
  std::size_t statements = 64; // kept prepared on each connection
};

const std::vector<OptionDescription>& mariadb_option_descriptions();

// Secrets and certificates may lie anywhere. An error of kind Settings names
// the option that is wrong, never what a secret says.
Expected<MariaDBOptions>
read_mariadb_options(const Options& options,
                     const std::string& application_folder);

} // namespace parlour::adapters
