// Functions that open SQLite databases and check files. The handles are not
// thread-safe (SQLITE_OPEN_NOMUTEX).
#pragma once

#include <filesystem>

#include "adapters/database/sqlite/sqlite_connection.hpp"
#include "runtime/base/error.hpp"

namespace parlour::adapters {

// What to do about a file that does not exist.
enum class Missing { create, refuse };

// Opens a new, empty database in memory.
Expected<SQLiteHandle> open_memory();

// Opens a file. The error has the kind File.
Expected<SQLiteHandle> open_file(const std::filesystem::path& file,
                                 Missing missing);

// Checks that an existing file is an intact database. The error, of kind
// Database, says what to do about one that is not. Small files are read
// completely. Waits for other programs for at most `busy_timeout`.
Expected<void> check_sound(const std::filesystem::path& file,
                           Milliseconds busy_timeout);

// Switches the file to write-ahead logging (WAL), in which readers and a writer
// work at the same time. Waits for other programs for at most `busy_timeout`,
// as all later statements do. The error, of kind File, says why the file cannot
// be written.
Expected<void> allow_writing(sqlite3* handle, const std::filesystem::path& file,
                             Milliseconds busy_timeout);

} // namespace parlour::adapters
