// An SQLiteImage is a new database as bytes, made from schema and seed. It is
// built once in a process. Each conversation of a test opens a copy of it in
// memory within microseconds, and a missing database file is written from it.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "adapters/database/sqlite/sqlite_connection.hpp"
#include "runtime/base/error.hpp"

namespace parlour::adapters {

// Immutable and shared; the images are thread-safe.
using SQLiteImage = std::shared_ptr<const std::string>;

// Builds the image, or returns the one that was built from the same texts: a
// file that has changed gives a new image. Either path may be empty.
// Thread-safe. Errors: File if a file cannot be read, Database with file and
// line for SQL that fails.
Expected<SQLiteImage> sqlite_image(const std::filesystem::path& schema,
                                   const std::filesystem::path& seed);

// The texts of schema and seed, joined by a zero byte.
Expected<std::string> sqlite_sources(const std::filesystem::path& schema,
                                     const std::filesystem::path& seed);

// A new database in memory with the image's content. It does not share its
// memory with the image.
Expected<SQLiteHandle> open_image(const SQLiteImage& image);

// Writes the image to `file`, with the folders it needs. The file appears
// complete or not at all, since it is written under another name and renamed.
Expected<void> write_image(const SQLiteImage& image,
                           const std::filesystem::path& file);

} // namespace parlour::adapters
