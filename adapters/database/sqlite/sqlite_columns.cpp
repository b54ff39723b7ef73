#include "adapters/database/sqlite/sqlite_columns.hpp"

#include "adapters/database/column_reference.hpp"
#include "adapters/database/sqlite/sqlite_image.hpp"
#include "adapters/database/sqlite/sqlite_open.hpp"

namespace parlour::adapters {

namespace {

constexpr SQLiteLimits column_limits{.rows = max_column_rows,
                                     .bytes = max_column_bytes,
                                     .steps = 1'000'000'000,
                                     .statements = 1};

// Whether the database is a file that already exists.
bool is_there(const SQLiteOptions& options) {
  return !options.in_memory() && std::filesystem::exists(options.file);
}

// The parts of an error message that name the file and say what to do about it.
// They are empty for a database in memory.
std::string source(const SQLiteOptions& options) {
  return is_there(options) ? " from " + options.file.string() : "";
}

std::string way_out(const SQLiteOptions& options) {
  return is_there(options) ? ". Put a database of this application in its "
                             "place, or move it away to have it made anew from "
                             "schema and seed."
                           : "";
}

// Never creates the file: reading the vocabulary is no reason to begin a
// database.
Expected<SQLiteHandle> open_to_read(const SQLiteOptions& options) {
  if (is_there(options))
    return open_file(options.file, Missing::refuse);
  auto image = sqlite_image(options.schema, options.seed);
  if (!image)
    return tl::make_unexpected(image.error());
  return open_image(*image);
}

} // namespace

Expected<std::vector<std::string>> read_column(SQLiteConnection& connection,
                                               const std::string& reference) {
  return parse_column(reference).and_then([&](const ColumnReference& place) {
    return connection.texts(select_values_of(place), column_limits);
  });
}

Expected<std::vector<std::string>> read_column(const SQLiteOptions& options,
                                               const std::string& reference) {
  if (const auto place = parse_column(reference); !place)
    return tl::make_unexpected(place.error());
  auto handle = open_to_read(options);
  if (!handle)
    return tl::make_unexpected(handle.error());
  SQLiteConnection connection(std::move(*handle), column_limits,
                              options.busy_timeout);
  return read_column(connection, reference).map_error([&](const Error& error) {
    return Error{error.kind,
                 "The column '" + reference + "' cannot be read" +
                     source(options) + ": " + error.message + way_out(options),
                 {}};
  });
}

ColumnReader sqlite_column_reader(const Options& options,
                                  const std::string& data_folder,
                                  const std::string& application_folder) {
  // The options are read once, here.
  return [read = read_sqlite_options(options, data_folder, application_folder)](
             const std::string& reference) {
    return read.and_then([&](const SQLiteOptions& known) {
      return read_column(known, reference);
    });
  };
}

} // namespace parlour::adapters
