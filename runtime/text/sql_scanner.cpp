#include "runtime/text/sql_scanner.hpp"

#include <algorithm>

namespace parlour {

namespace {

bool is_blank(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

// What MariaDB needs behind `--` for a comment.
bool is_blank_or_control(char c) {
  return (c >= 0 && c <= ' ') || c == 0x7f;
}

char closing_mark(char opening) {
  return opening == '[' ? ']' : opening;
}

// Bytes outside of ASCII belong to words, so names may be in any language.
bool is_of_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
         (c >= '0' && c <= '9') || c == '_' || c == '$' ||
         (static_cast<unsigned char>(c) & 0x80) != 0;
}

} // namespace

bool SqlToken::is_open() const {
  return kind == SqlTokenKind::quoted &&
         (text.size() == 1 || text.back() != closing_mark(text.front()));
}

SqlToken SqlScanner::next() {
  const auto kind = kind_of_next();
  const SqlToken token{kind, rest_.substr(0, length_of(kind))};
  rest_.remove_prefix(token.text.size());
  return token;
}

SqlTokenKind SqlScanner::kind_of_next() const {
  const char c = rest_.front();
  if (is_blank(c) || is_remark())
    return SqlTokenKind::blank;
  if (c == ';')
    return SqlTokenKind::semicolon;
  if (c == '?' || (c == ':' && rest_.size() > 1 && is_of_word(rest_[1])))
    return SqlTokenKind::placeholder;
  if (is_quote(c))
    return SqlTokenKind::quoted;
  return is_of_word(c) ? SqlTokenKind::word : SqlTokenKind::other;
}

bool SqlScanner::is_quote(char c) const {
  return c == '\'' || c == '"' || c == '`' ||
         (c == '[' && dialect_ == SqlDialect::sqlite);
}

bool SqlScanner::is_remark() const {
  return is_line_remark() || (rest_.starts_with("/*") && !is_run_by_mariadb());
}

// MariaDB runs what stands between `/*!` and `*/`, so that is no comment.
bool SqlScanner::is_run_by_mariadb() const {
  return dialect_ == SqlDialect::mariadb &&
         (rest_.starts_with("/*!") || rest_.starts_with("/*M!"));
}

bool SqlScanner::is_line_remark() const {
  if (!rest_.starts_with("--"))
    return rest_.front() == '#';
  return dialect_ == SqlDialect::sqlite || rest_.size() == 2 ||
         is_blank_or_control(rest_[2]);
}

std::size_t SqlScanner::length_of(SqlTokenKind kind) const {
  const char mark = closing_mark(rest_.front());
  switch (kind) {
  case SqlTokenKind::blank:
    return length_of_blank();
  case SqlTokenKind::word:
  case SqlTokenKind::placeholder:
    return length_of_word();
  case SqlTokenKind::quoted:
    return behind({&mark, 1}, 1);
  case SqlTokenKind::semicolon:
  case SqlTokenKind::other:
    break;
  }
  return 1;
}

std::size_t SqlScanner::length_of_blank() const {
  if (is_line_remark())
    return std::min(rest_.find('\n'), rest_.size());
  return is_remark() ? behind("*/", 2) : 1;
}

std::size_t SqlScanner::length_of_word() const {
  return static_cast<std::size_t>(
      std::find_if_not(rest_.begin() + 1, rest_.end(), is_of_word) -
      rest_.begin());
}

// The length up to the end of the mark, which is looked for at `from`; without
// the mark, all that is left.
std::size_t SqlScanner::behind(std::string_view mark, std::size_t from) const {
  const auto found = rest_.find(mark, from);
  return found == std::string_view::npos ? rest_.size() : found + mark.size();
}

std::string sql_lower(std::string_view word) {
  std::string lower(word);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z')
      c = static_cast<char>(c | 0x20);
  return lower;
}

std::string first_sql_word(std::string_view sql, SqlDialect dialect) {
  for (SqlScanner scanner(sql, dialect); !scanner.at_end();) {
    const auto token = scanner.next();
    if (token.kind == SqlTokenKind::semicolon)
      break;
    if (token.kind != SqlTokenKind::blank)
      return sql_lower(token.text);
  }
  return {};
}

} // namespace parlour
