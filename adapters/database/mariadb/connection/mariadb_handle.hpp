// MariaDBHandle owns a connection of the C library, with what the options say
// of it. It makes no call that waits.
#pragma once

#include "adapters/database/mariadb/connection/mariadb_options.hpp"

struct st_mysql;

namespace parlour::adapters {

class MariaDBHandle {
public:
  // It is not connected yet.
  explicit MariaDBHandle(const MariaDBOptions& options);
  MariaDBHandle(const MariaDBHandle&) = delete;
  MariaDBHandle& operator=(const MariaDBHandle&) = delete;
  // Closes the connection. Its statements are detached from it.
  ~MariaDBHandle();

  st_mysql* get() const {
    return handle_;
  }
  int descriptor() const;

private:
  void set_options(const MariaDBOptions& options);
  void set_tls(const MariaDBOptions& options);

  st_mysql* const handle_;
};

} // namespace parlour::adapters
