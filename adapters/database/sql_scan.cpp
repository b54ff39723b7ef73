#include "adapters/database/sql_scan.hpp"

#include <algorithm>

#include "runtime/text/sql_scanner.hpp"

namespace parlour::adapters {

namespace {

std::uint32_t lines_of(std::string_view text) {
  return static_cast<std::uint32_t>(std::count(text.begin(), text.end(), '\n'));
}

} // namespace

ScannedSql scan_sql(std::string_view sql) {
  ScannedSql scanned;
  scanned.first_word = first_sql_word(sql, SqlDialect::mariadb);
  bool ended = false;
  // Until the first ';' tokens are copied; after it, any token that is not
  // blank means that a second statement follows.
  for (SqlScanner scanner(sql, SqlDialect::mariadb); !scanner.at_end();) {
    const auto token = scanner.next();
    if (token.kind == SqlTokenKind::semicolon) {
      ended = true;
      continue;
    }
    scanned.more |= ended && token.kind != SqlTokenKind::blank;
    if (ended)
      continue;
    const bool is_placeholder = token.kind == SqlTokenKind::placeholder;
    if (is_placeholder)
      scanned.names.emplace_back(token.text.substr(1));
    scanned.text += is_placeholder ? "?" : token.text;
  }
  return scanned;
}

std::vector<SqlPart> split_sql(std::string_view text) {
  std::vector<SqlPart> parts;
  // The first token of the current statement, or null between two statements.
  const char* begin = nullptr;
  std::uint32_t line = 1;
  std::uint32_t line_of_begin = 1;
  const auto end_at = [&](const char* end) {
    if (begin)
      parts.push_back(
          {{begin, static_cast<std::size_t>(end - begin)}, line_of_begin});
    begin = nullptr;
  };
  // `line` is the line on which the current token begins.
  for (SqlScanner scanner(text, SqlDialect::mariadb); !scanner.at_end();) {
    const auto token = scanner.next();
    if (token.kind == SqlTokenKind::semicolon) {
      end_at(token.text.data());
    } else if (token.kind != SqlTokenKind::blank && !begin) {
      begin = token.text.data();
      line_of_begin = line;
    }
    line += lines_of(token.text);
  }
  end_at(text.data() + text.size());
  return parts;
}

} // namespace parlour::adapters
