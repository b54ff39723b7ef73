#include "adapters/database/mariadb/connection/connection_state.hpp"

#include "adapters/database/mariadb/connection/mariadb_errors.hpp"
#include "adapters/database/statement.hpp"

namespace parlour::adapters {

tl::unexpected<Error> ConnectionState::failed(std::string_view sql,
                                              unsigned code, const char* reason,
                                              bool is_late) {
  constexpr unsigned only_reading = 1792;
  code_ = code;
  in_doubt_ = in_doubt_ && says_nothing_of_statement(code);
  ended_transaction_ = ends_transaction(code);
  lost_ = lost_ || ends_connection(code);
  if (code == only_reading)
    return only_reads(sql);
  // A call that was ended at its deadline reports a lost connection; to the
  // script that is a timeout.
  const bool late = lost_ && is_late;
  return fail(late ? ErrorKind::timeout : mariadb_error_kind(code),
              (sql.empty() ? "" : first_words(sql) + " failed: ") + reason +
                  (late ? " (no answer in time)." : "."));
}

} // namespace parlour::adapters
