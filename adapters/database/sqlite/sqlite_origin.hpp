// Records from which schema and seed a database file was made, as a hash in
// FILE.made-from. An existing file is used even if its sources have changed
// since; the user is then told, and can have it made anew (`parlour run
// --fresh`).
#pragma once

#include "adapters/database/sqlite/sqlite_options.hpp"
#include "runtime/base/error.hpp"

namespace parlour::adapters {

// Writes the record for the database that was just created.
Expected<void> note_origin(const SQLiteOptions& options);

// Whether schema or seed differ from those of the record. False if there is no
// record or the sources cannot be read.
bool has_other_origin(const SQLiteOptions& options);

// Renames the database with all files that belong to it to FILE.before, or to
// FILE.before-2, -3 … if that name is taken. Does nothing if there is no file.
Expected<void> put_aside(const std::filesystem::path& file);

} // namespace parlour::adapters
