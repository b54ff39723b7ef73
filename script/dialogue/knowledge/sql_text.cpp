#include "script/dialogue/knowledge/sql_text.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "runtime/text/sql_scanner.hpp"

namespace parlour::dialogue {

namespace {

constexpr auto npos = std::string::npos;

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

// A word at the top level, in lower case.
struct Word {
  std::size_t from = 0;
  std::size_t to = 0;
  std::string text;
};

// What stands in parentheses belongs to a subquery or a function, and is left
// out; so are quoted names, texts and comments, which the scanner knows.
std::vector<Word> words_of(std::string_view sql) {
  std::vector<Word> words;
  int depth = 0;
  for (SqlScanner scanner(sql); !scanner.at_end();) {
    const auto token = scanner.next();
    const auto from = static_cast<std::size_t>(token.text.data() - sql.data());
    if (token.kind == SqlTokenKind::other)
      depth += token.text == "(" ? 1 : token.text == ")" ? -1 : 0;
    else if (token.kind == SqlTokenKind::word && depth == 0)
      words.push_back({from, from + token.text.size(), sql_lower(token.text)});
  }
  return words;
}

template <std::size_t size>
bool is_one_of(const Word& word,
               const std::array<std::string_view, size>& names) {
  return std::find(names.begin(), names.end(), word.text) != names.end();
}

constexpr std::array<std::string_view, 3> unions{"union", "intersect",
                                                 "except"};
// The clauses that may follow a where; the condition must come before them.
constexpr std::array<std::string_view, 6> after_where{
    "group", "having", "window", "order", "limit", "offset"};
constexpr std::array<std::string_view, 3> after_order{"limit", "offset",
                                                      "fetch"};

// Where the first of these words stands, from `from` on; else the end.
template <std::size_t size>
std::size_t first_of(const std::vector<Word>& words, std::size_t from,
                     const std::array<std::string_view, size>& names,
                     std::size_t end) {
  for (const auto& word : words)
    if (word.from >= from && is_one_of(word, names))
      return word.from;
  return end;
}

const Word* find_word(const std::vector<Word>& words, std::string_view text) {
  auto found = std::find_if(words.begin(), words.end(),
                            [&](const Word& w) { return w.text == text; });
  return found == words.end() ? nullptr : &*found;
}

std::string trimmed(std::string_view text) {
  auto from = std::find_if_not(text.begin(), text.end(), is_blank);
  auto last = text.end();
  while (last != from && (is_blank(*(last - 1)) || *(last - 1) == ';'))
    --last;
  return std::string(from, last);
}

// Puts `part` between two others with one blank on each side.
std::string between(const std::string& text, std::size_t at,
                    const std::string& part) {
  auto head = trimmed(std::string_view(text).substr(0, at));
  auto tail = trimmed(std::string_view(text).substr(at));
  return head + " " + part + (tail.empty() ? "" : " " + tail);
}

// The statement's own condition is put in parentheses if it has an `or`, which
// would otherwise let rows past the new one: "a or b and c" is "a or (b and
// c)".
std::string add_condition(std::string sql, const std::string& condition) {
  const auto words = words_of(sql);
  const auto* where = find_word(words, "where");
  const auto end =
      first_of(words, where ? where->to : 0, after_where, sql.size());
  if (!where)
    return between(sql, end, "where " + condition);
  auto own = trimmed(std::string_view(sql).substr(where->to, end - where->to));
  const bool has_or = std::any_of(words.begin(), words.end(), [&](auto& word) {
    return word.text == "or" && word.from > where->to && word.from < end;
  });
  if (has_or)
    own = "(" + own + ")";
  auto remaining = sql.substr(end);
  return sql.substr(0, where->to) + " " + own + " and (" + condition + ")" +
         (remaining.empty() ? "" : " " + remaining);
}

// The author's own order comes first.
std::string add_order(std::string sql, const std::string& order) {
  const auto words = words_of(sql);
  const auto* own = find_word(words, "order");
  const auto end = first_of(words, own ? own->to : 0, after_order, sql.size());
  if (!own)
    return between(sql, end, "order by " + order);
  auto head = trimmed(std::string_view(sql).substr(0, end));
  auto remaining = sql.substr(end);
  return head + ", " + order + (remaining.empty() ? "" : " " + remaining);
}

} // namespace

std::string with_condition(std::string_view statement,
                           std::string_view condition, std::string_view order) {
  auto sql = trimmed(statement);
  const auto words = words_of(sql);
  const bool joined = std::any_of(words.begin(), words.end(), [](auto& word) {
    return is_one_of(word, unions);
  });
  if (joined && !condition.empty())
    sql = "select * from (" + sql + ") as answer";
  if (!condition.empty())
    sql = add_condition(std::move(sql), std::string(condition));
  if (!order.empty())
    sql = add_order(std::move(sql), std::string(order));
  return sql;
}

std::string escape_like(std::string_view text) {
  std::string escaped;
  for (char c : text) {
    if (c == '%' || c == '_' || c == '!')
      escaped += '!';
    escaped += c;
  }
  return escaped;
}

} // namespace parlour::dialogue
