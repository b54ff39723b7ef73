#include "runtime/text/sql_check.hpp"

#include <algorithm>
#include <cctype>

#include "runtime/text/sql_scanner.hpp"

namespace parlour {

namespace {

constexpr auto npos = std::string_view::npos;

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n";
  const auto from = std::min(text.find_first_not_of(blanks), text.size());
  const auto last = text.find_last_not_of(blanks);
  return text.substr(from, last == npos ? 0 : last + 1 - from);
}

// The parts between commas, trimmed; empty parts are left out.
std::vector<std::string_view> parts_of(std::string_view list) {
  std::vector<std::string_view> parts;
  for (std::size_t from = 0; from <= list.size();) {
    const auto end = std::min(list.find(',', from), list.size());
    if (const auto part = trimmed(list.substr(from, end - from)); !part.empty())
      parts.push_back(part);
    from = end + 1;
  }
  return parts;
}

// Reads one column. The last word is the direction if it is `asc` or `desc`,
// unless it is the only word: then it is the name of a column.
SortColumn sort_column(std::string_view text) {
  const auto blank = text.find_last_of(" \t\r\n");
  const auto way = blank == npos ? "" : text.substr(blank + 1);
  if (way == "desc" || way == "asc")
    text = trimmed(text.substr(0, blank));
  return {std::string(text), way == "desc"};
}

bool is_plain_name(std::string_view text) {
  const auto is_part = [](char letter) {
    return std::isalnum(static_cast<unsigned char>(letter)) || letter == '_';
  };
  return !text.empty() && !std::isdigit(static_cast<unsigned char>(text[0])) &&
         std::all_of(text.begin(), text.end(), is_part);
}

std::string wrong_select(std::string_view sql, SqlDialect dialect) {
  const auto word = first_sql_word(sql, dialect);
  if (word != "select" && word != "with")
    return "expected one select statement";
  // Blanks and comments are the only tokens that may follow the semicolon.
  bool ended = false;
  bool more = false;
  for (SqlScanner scanner(sql, dialect); !scanner.at_end();) {
    const auto token = scanner.next();
    if (!ended && token.is_open())
      return "a quotation mark in this statement does not end";
    more |= ended && token.kind != SqlTokenKind::blank;
    ended |= token.kind == SqlTokenKind::semicolon;
  }
  return more ? "expected one statement only; there is more behind the ';'"
              : "";
}

// Words that occur, outside of quotes, in what does more than to look: `select
// … into outfile`, `select … for update`, `with x as (delete …)`, `select
// nextval(s)`. Inserting needs `into`.
constexpr std::string_view words_of_deeds[] = {
    "into", "update",   "delete",       "returning",
    "for",  "lock",     "nextval",      "setval",
    "call", "get_lock", "release_lock", "release_all_locks"};

bool only_looks(std::string_view sql, SqlDialect dialect) {
  for (SqlScanner scanner(sql, dialect); !scanner.at_end();) {
    const auto token = scanner.next();
    if (token.kind == SqlTokenKind::word &&
        std::ranges::count(words_of_deeds, sql_lower(token.text)) > 0)
      return false;
  }
  return true;
}

// Without comments, and without quotes but plain ones, both dialects see the
// same tokens.
bool is_read_alike(std::string_view sql) {
  return sql.find_first_of("\"`[\\#/-") == npos;
}

} // namespace

bool only_looks(std::string_view sql) {
  const auto looks = [&](SqlDialect dialect) {
    return wrong_select(sql, dialect).empty() && only_looks(sql, dialect);
  };
  return looks(SqlDialect::sqlite) &&
         (is_read_alike(sql) || looks(SqlDialect::mariadb));
}

std::string wrong_select(std::string_view sql) {
  auto wrong = wrong_select(sql, SqlDialect::sqlite);
  if (!wrong.empty())
    return wrong;
  wrong = wrong_select(sql, SqlDialect::mariadb);
  return wrong.empty() ? wrong
                       : wrong + " (as MariaDB reads it: a comment begins with "
                                 "'--' and a blank, and '/*!' begins none)";
}

bool is_sql_name(std::string_view text) {
  const auto dot = text.find('.');
  if (dot == npos)
    return is_plain_name(text);
  return is_plain_name(text.substr(0, dot)) &&
         is_sql_name(text.substr(dot + 1));
}

bool is_column_source(std::string_view text) {
  constexpr std::string_view prefix = "db:";
  if (!text.starts_with(prefix))
    return false;
  text.remove_prefix(prefix.size());
  return text.find('.') != npos && is_sql_name(text);
}

std::vector<SortColumn> sort_columns(std::string_view order) {
  std::vector<SortColumn> columns;
  for (const auto part : parts_of(order)) {
    columns.push_back(sort_column(part));
    if (!is_sql_name(columns.back().name))
      return {};
  }
  return columns;
}

} // namespace parlour
