// What must be known before MariaDB sees SQL text: its placeholders, its
// first word, and where each statement ends (runtime/text/sql_scanner). Time is
// linear in the length of the text.
//
//  scan_sql("select a from t where b = :level")
//    .text == "select a from t where b = ?"
//    .names == {"level"}
//    .first_word == "select"
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace parlour::adapters {

struct ScannedSql {
  // The statement without its ';'. Each placeholder is written as `?`.
  std::string text;
  // The name of each placeholder, in order; "" for a plain `?`.
  std::vector<std::string> names;
  // In lower case. Empty if the text has no statement.
  std::string first_word;
  // Whether another token follows the statement's ';'.
  bool more = false;
};

ScannedSql scan_sql(std::string_view sql);

struct SqlPart {
  // The statement without its ';'. It points into the text of the file.
  std::string_view text;
  // The line on which it begins, counted from 1.
  std::uint32_t line;
};

// Splits a file into its statements. `text` must outlive the result.
std::vector<SqlPart> split_sql(std::string_view text);

} // namespace parlour::adapters
