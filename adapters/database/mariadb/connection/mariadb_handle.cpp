#include "adapters/database/mariadb/connection/mariadb_handle.hpp"

#include <cstddef>
#include <string>

#include <mysql.h>
#include <sys/socket.h>

#include "adapters/database/mariadb/connection/mariadb_dialect.hpp"

namespace parlour::adapters {

namespace {

// A cell that exceeds the limit of a result by up to this much still arrives,
// so that the statement fails with kind Limit instead of losing the connection.
constexpr std::size_t packet_beyond_limit = 16 << 20;

const char* or_null(const std::string& text) {
  return text.empty() ? nullptr : text.c_str();
}

} // namespace

MariaDBHandle::MariaDBHandle(const MariaDBOptions& options)
    : handle_(mysql_init(nullptr)) {
  set_options(options);
  if (options.tls != MariaDBOptions::Tls::off)
    set_tls(options);
}

// The socket is shut down first, so that closing does not wait for a server
// that owes an answer.
MariaDBHandle::~MariaDBHandle() {
  if (const auto socket = descriptor(); socket >= 0)
    shutdown(socket, SHUT_RDWR);
  mysql_close(handle_);
}

int MariaDBHandle::descriptor() const {
  return static_cast<int>(mysql_get_socket(handle_));
}

void MariaDBHandle::set_options(const MariaDBOptions& options) {
  mysql_options(handle_, MYSQL_OPT_NONBLOCK, nullptr);
  mysql_options(handle_, MYSQL_SET_CHARSET_NAME, "utf8mb4");
  for (const auto& command : dialect_commands(options))
    mysql_options(handle_, MYSQL_INIT_COMMAND, command.c_str());
  const unsigned off = 0;
  mysql_options(handle_, MYSQL_OPT_LOCAL_INFILE, &off);
  // Without a port, "localhost" means the Unix socket.
  if (options.port != 0) {
    const auto protocol = MYSQL_PROTOCOL_TCP;
    mysql_options(handle_, MYSQL_OPT_PROTOCOL, &protocol);
  }
  const unsigned long packet = options.bytes + packet_beyond_limit;
  mysql_options(handle_, MYSQL_OPT_MAX_ALLOWED_PACKET, &packet);
}

void MariaDBHandle::set_tls(const MariaDBOptions& options) {
  const my_bool yes = 1;
  const my_bool verify = options.tls == MariaDBOptions::Tls::verify;
  mysql_options(handle_, MYSQL_OPT_SSL_ENFORCE, &yes);
  mysql_options(handle_, MYSQL_OPT_SSL_VERIFY_SERVER_CERT, &verify);
  mysql_ssl_set(handle_, or_null(options.tls_key.string()),
                or_null(options.tls_certificate.string()),
                or_null(options.tls_ca.string()), nullptr, nullptr);
}

} // namespace parlour::adapters
