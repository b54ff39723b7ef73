#include "adapters/database/sqlite/sqlite_origin.hpp"

#include <fstream>
#include <string>

#include <fmt/format.h>

#include "adapters/database/sqlite/sqlite_image.hpp"

namespace parlour::adapters {

namespace {

namespace fs = std::filesystem;

constexpr auto mark_ending = ".made-from";

// 64-bit FNV-1a. Unlike std::hash it is the same in every build.
std::string mark_of(const std::string& text) {
  std::uint64_t mark = 14695981039346656037U;
  for (const char c : text)
    mark = (mark ^ static_cast<unsigned char>(c)) * 1099511628211U;
  return fmt::format("{:016x}", mark);
}

fs::path mark_file(const fs::path& file) {
  return file.string() + mark_ending;
}

// Empty if there is no record.
std::string mark_in(const fs::path& file) {
  std::string mark;
  std::ifstream(file) >> mark;
  return mark;
}

// Never overwrites a file that was put aside earlier.
std::string free_name(const std::string& wanted) {
  auto name = wanted;
  std::error_code ignored;
  for (int count = 2; fs::exists(name, ignored); ++count)
    name = wanted + "-" + std::to_string(count);
  return name;
}

} // namespace

Expected<void> note_origin(const SQLiteOptions& options) {
  const auto sources = sqlite_sources(options.schema, options.seed);
  if (!sources)
    return tl::make_unexpected(sources.error());
  const auto file = mark_file(options.file);
  if (std::ofstream(file) << mark_of(*sources) << std::endl)
    return {};
  return fail(ErrorKind::file, "The mark of the database cannot be written.",
              {file.string(), 0, 0});
}

bool has_other_origin(const SQLiteOptions& options) {
  const auto mark = mark_in(mark_file(options.file));
  const auto sources = sqlite_sources(options.schema, options.seed);
  return !mark.empty() && sources && mark != mark_of(*sources);
}

Expected<void> put_aside(const fs::path& file) {
  std::error_code ignored;
  if (!fs::exists(file, ignored))
    return {};
  const auto aside = free_name(file.string() + ".before");
  // The write-ahead log belongs to the database: without it the last changes
  // are lost.
  for (const auto* ending : {"", "-wal", "-shm", "-journal", mark_ending}) {
    const auto from = file.string() + ending;
    const auto to = aside + ending;
    std::error_code error;
    if (fs::exists(from, error))
      fs::rename(from, to, error);
    if (error)
      return fail(ErrorKind::file,
                  "The database cannot be put aside: " + error.message() + ".",
                  {from, 0, 0});
  }
  return {};
}

} // namespace parlour::adapters
