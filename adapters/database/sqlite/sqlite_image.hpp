// A fresh database as bytes, made from schema and seed once in a process:
// each conversation of a test gets a copy of its own in microseconds, and a
// missing file is written from it.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "adapters/database/sqlite/sqlite_connection.hpp"
#include "runtime/base/error.hpp"

namespace parlour::adapters {

using SQLiteImage = std::shared_ptr<const std::string>;

// From any thread; kept by the files' texts, so that a changed file makes a new
// image. Either path may be empty. Errors: File for a file that cannot be
// read, Database with the file's line for SQL that fails.
Expected<SQLiteImage> sqlite_image(const std::filesystem::path& schema,
                                   const std::filesystem::path& seed);

// The texts that it is made from, one behind the other.
Expected<std::string> sqlite_sources(const std::filesystem::path& schema,
                                     const std::filesystem::path& seed);

// A database in memory that begins as the image.
Expected<SQLiteHandle> open_image(const SQLiteImage& image);

// Puts the image where there is no file yet: whole, or not at all.
Expected<void> write_image(const SQLiteImage& image,
                           const std::filesystem::path& file);

} // namespace parlour::adapters
