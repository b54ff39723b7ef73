// Of which schema and seed a database file was made: their mark is kept beside
// it, in FILE.made-from. A file that was there before is used as it is, also
// where they have changed since; that is worth a word.
#pragma once

#include "adapters/database/sqlite/sqlite_options.hpp"
#include "runtime/base/error.hpp"

namespace parlour::adapters {

// Of the database that was just made.
Expected<void> note_origin(const SQLiteOptions& options);

// False where nobody knows.
bool has_other_origin(const SQLiteOptions& options);

// Away from its place, with what belongs to it: to FILE.before, or to
// FILE.before-2 and so on where that is there. Nothing happens where there is
// none.
Expected<void> put_aside(const std::filesystem::path& file);

} // namespace parlour::adapters
