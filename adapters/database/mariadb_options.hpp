// The settings of a MariaDB database, read once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

struct MariaDBOptions {
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
  std::filesystem::path schema; // empty: none
  std::filesystem::path seed;   // empty: none
  bool copy = false;            // a database of its own, dropped at the end
  bool one_by_one = false;      // each message answered before the next
  std::size_t connections = 4;
  Milliseconds connect_timeout{5'000};
  Milliseconds query_timeout{5'000};
  Milliseconds busy_timeout{2'000};
  Milliseconds transaction_timeout{30'000};
  std::size_t rows = 10'000;   // of a result
  std::size_t bytes = 4 << 20; // of a result's cells
  std::size_t statements = 64; // kept prepared on each connection
};

const std::vector<OptionDescription>& mariadb_option_descriptions();

// `schema` and `seed` lie in the application's folder (language rule 1);
// secrets and certificates may lie anywhere. An error of kind Settings names
// the option that is wrong, never what a secret says.
Expected<MariaDBOptions>
read_mariadb_options(const Options& options,
                     const std::string& application_folder);

} // namespace parlour::adapters
