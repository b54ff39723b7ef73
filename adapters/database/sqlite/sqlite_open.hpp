// Opening SQLite databases: in memory, a file, or what the settings say.
#pragma once

#include <filesystem>

#include "adapters/database/sqlite/sqlite_connection.hpp"
#include "runtime/base/error.hpp"

namespace parlour::adapters {

enum class Missing { create, refuse };

Expected<SQLiteHandle> open_memory();

Expected<SQLiteHandle> open_file(const std::filesystem::path& file,
                                 Missing missing);

// Looks whether an existing file is a sound database; the error (kind
// Database) says what to do about one that is not.
Expected<void> check_sound(const std::filesystem::path& file);

// Lets readers and a writer work at the same time (WAL). The error (kind File)
// says why the file cannot be written.
Expected<void> allow_writing(sqlite3* handle,
                             const std::filesystem::path& file);

} // namespace parlour::adapters
