// What the text of a statement is made of, as far as it matters before a
// server sees it: quotes and comments as SQLite and MariaDB (with ANSI_QUOTES
// and NO_BACKSLASH_ESCAPES) agree on them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace parlour::adapters {

struct ScannedSql {
  std::string text;               // each placeholder written as `?`
  std::vector<std::string> names; // of placeholders; empty for a `?`
  std::string first_word;         // small letters; empty: no statement
  bool more = false;              // something follows its ';'
};

ScannedSql scan_sql(std::string_view sql);

struct SqlPart {
  std::string_view text; // of the file's, without its ';'
  std::uint32_t line;    // where it begins
};

// The statements of a file. The text outlives them.
std::vector<SqlPart> split_sql(std::string_view text);

} // namespace parlour::adapters
