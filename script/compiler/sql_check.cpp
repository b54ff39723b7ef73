#include "script/compiler/sql_check.hpp"

#include <algorithm>
#include <cctype>

#include "script/compiler/compilation.hpp"

namespace parlour::script {

namespace {

constexpr auto npos = std::string_view::npos;

char lower(char letter) {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
}

std::string first_word(std::string_view text) {
  std::string word;
  for (const char letter : text) {
    if (!std::isalpha(static_cast<unsigned char>(letter)))
      break;
    word += lower(letter);
  }
  return word;
}

// The first `;` outside of quotes; a quote that does not end gives npos and
// sets `open`.
std::size_t find_end(std::string_view sql, bool& open) {
  char quote = 0;
  for (std::size_t i = 0; i < sql.size(); ++i) {
    if (quote)
      quote = sql[i] == quote ? '\0' : quote;
    else if (sql[i] == '\'' || sql[i] == '"' || sql[i] == '`')
      quote = sql[i];
    else if (sql[i] == ';')
      return i;
  }
  open = quote != 0;
  return npos;
}

bool is_plain_name(std::string_view text) {
  const auto is_part = [](char letter) {
    return std::isalnum(static_cast<unsigned char>(letter)) || letter == '_';
  };
  return !text.empty() && !std::isdigit(static_cast<unsigned char>(text[0])) &&
         std::all_of(text.begin(), text.end(), is_part);
}

} // namespace

std::string wrong_select(std::string_view sql) {
  const auto text = collapsed(sql);
  const auto word = first_word(text);
  if (word != "select" && word != "with")
    return "expected one select statement";
  bool open = false;
  const auto end = find_end(text, open);
  if (open)
    return "a quotation mark in this statement does not end";
  if (end != npos && end + 1 < text.size())
    return "expected one statement only; there is more behind the ';'";
  return {};
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
  for (const auto& part : split_names(std::string(order))) {
    std::string_view name = part;
    const bool falling = name.ends_with(" desc");
    if (falling || name.ends_with(" asc"))
      name = name.substr(0, name.rfind(' '));
    if (!is_sql_name(name))
      return {};
    columns.push_back({std::string(name), falling});
  }
  return columns;
}

} // namespace parlour::script
