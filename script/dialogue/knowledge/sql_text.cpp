#include "script/dialogue/knowledge/sql_text.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace parlour::dialogue {

namespace {

constexpr auto npos = std::string::npos;

bool is_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
         (c >= '0' && c <= '9') || c == '_' || c == '$' ||
         static_cast<unsigned char>(c) >= 0x80;
}

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

// A word at the top level, in lower case.
struct Word {
  std::size_t from = 0;
  std::size_t to = 0;
  std::string text;
};

class Scanner {
public:
  explicit Scanner(std::string_view text) : text_(text) {}

  std::vector<Word> words() {
    while (at_ < text_.size())
      step();
    return std::move(words_);
  }

private:
  void step() {
    const char c = text_[at_];
    if (c == '\'' || c == '"' || c == '`')
      skip_past(std::string(1, c), at_ + 1);
    else if (text_.substr(at_, 2) == "--")
      skip_past("\n", at_ + 2);
    else if (text_.substr(at_, 2) == "/*")
      skip_past("*/", at_ + 2);
    else if (is_word(c))
      word();
    else
      punctuation(c);
  }

  // A doubled quote is two strings side by side: as good for us.
  void skip_past(std::string_view end, std::size_t from) {
    auto found = text_.find(end, from);
    at_ = found == npos ? text_.size() : found + end.size();
  }

  void punctuation(char c) {
    depth_ += c == '(' ? 1 : c == ')' ? -1 : 0;
    ++at_;
  }

  void word() {
    Word word{at_, at_, {}};
    for (; at_ < text_.size() && is_word(text_[at_]); ++at_)
      word.text += static_cast<char>(text_[at_] >= 'A' && text_[at_] <= 'Z'
                                         ? text_[at_] | 0x20
                                         : text_[at_]);
    word.to = at_;
    if (depth_ == 0)
      words_.push_back(std::move(word));
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int depth_ = 0;
  std::vector<Word> words_;
};

template <std::size_t size>
bool is_one_of(const Word& word,
               const std::array<std::string_view, size>& names) {
  return std::find(names.begin(), names.end(), word.text) != names.end();
}

constexpr std::array<std::string_view, 3> unions{"union", "intersect",
                                                 "except"};
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

std::string add_condition(std::string sql, const std::string& condition) {
  const auto words = Scanner(sql).words();
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
  auto rest = sql.substr(end);
  return sql.substr(0, where->to) + " " + own + " and (" + condition + ")" +
         (rest.empty() ? "" : " " + rest);
}

std::string add_order(std::string sql, const std::string& order) {
  const auto words = Scanner(sql).words();
  const auto* own = find_word(words, "order");
  const auto end = first_of(words, own ? own->to : 0, after_order, sql.size());
  if (!own)
    return between(sql, end, "order by " + order);
  auto head = trimmed(std::string_view(sql).substr(0, end));
  auto rest = sql.substr(end);
  return head + ", " + order + (rest.empty() ? "" : " " + rest);
}

} // namespace

std::string with_condition(std::string_view statement,
                           std::string_view condition, std::string_view order) {
  auto sql = trimmed(statement);
  const auto words = Scanner(sql).words();
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
