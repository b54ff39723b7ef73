#include "adapters/database/mariadb/mariadb_columns.hpp"

#include <memory>
#include <utility>

#include "adapters/database/mariadb/connection/mariadb_connection.hpp"
#include "adapters/database/mariadb/connection/mariadb_errors.hpp"
#include "adapters/database/sqlite/sqlite_columns.hpp"

namespace parlour::adapters {

namespace {

using Texts = Expected<std::vector<std::string>>;

// Runs schema and seed in an SQLite database in memory and reads it there, so
// that no server is needed.
Texts of_schema_and_seed(const MariaDBOptions& options,
                         const std::string& reference) {
  SQLiteOptions made;
  made.schema = options.schema;
  made.seed = options.seed;
  return read_column(made, reference);
}

Texts read_column(const MariaDBOptions& options, const std::string& reference) {
  if (options.copy)
    return of_schema_and_seed(options, reference);
  const auto place = parse_column(reference);
  if (!place)
    return tl::make_unexpected(place.error());
  MariaDBConnection connection(std::make_shared<const MariaDBOptions>(options));
  auto values =
      carry_out(connection, connection.open(MariaDBConnection::To::database))
          .and_then([&](const StatementAnswer&) {
            connection.give_time(options.query_timeout);
            return read_column(connection, *place);
          });
  // The server answers, but the database or the table does not exist: it will
  // be created when the component starts.
  const auto code = connection.state().code();
  const bool is_not_made =
      code == mariadb_unknown_database || code == mariadb_no_such_table;
  if (!values && is_not_made && !options.schema.empty())
    return of_schema_and_seed(options, reference);
  if (!values)
    return fail(values.error().kind, "The column '" + reference +
                                         "' cannot be read from the database "
                                         "'" +
                                         options.database +
                                         "': " + values.error().message);
  return values;
}

} // namespace

MariaDBOptions with_room_for_a_column(MariaDBOptions options) {
  options.rows = max_column_rows;
  options.bytes = max_column_bytes;
  return options;
}

Expected<std::vector<std::string>> read_column(MariaDBConnection& connection,
                                               const ColumnReference& place) {
  auto answer = carry_out(
      connection, connection.run(select_values_of(place), {}, Access::read));
  if (!answer)
    return tl::make_unexpected(answer.error());
  std::vector<std::string> values;
  for (const auto& cell : answer->rows.cells)
    values.push_back(cell.text());
  return values;
}

ColumnReader mariadb_column_reader(const Options& options,
                                   const std::string& application_folder) {
  auto read = read_mariadb_options(options, application_folder);
  if (read)
    *read = with_room_for_a_column(std::move(*read));
  return [read = std::move(read)](const std::string& reference) {
    return read.and_then([&](const MariaDBOptions& known) {
      return read_column(known, reference);
    });
  };
}

} // namespace parlour::adapters
