#include "adapters/database/sql_scan.hpp"

#include <algorithm>
#include <cctype>

namespace parlour::adapters {

namespace {

enum class TokenKind : std::uint8_t {
  blank,
  word,
  placeholder,
  semicolon,
  other
};

struct Token {
  TokenKind kind;
  std::string_view text;
};

bool is_blank(char c) {
  return std::isspace(static_cast<unsigned char>(c)) != 0;
}

bool is_of_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' ||
         (static_cast<unsigned char>(c) & 0x80) != 0;
}

// Tokens from the front of what is left.
class Scanner {
public:
  explicit Scanner(std::string_view text) : rest_(text) {}

  bool at_end() const {
    return rest_.empty();
  }

  Token next() {
    const auto kind = look();
    const auto length = std::min(length_of(kind), rest_.size());
    const Token token{kind, rest_.substr(0, length)};
    rest_.remove_prefix(length);
    return token;
  }

private:
  TokenKind look() const {
    const char c = rest_.front();
    if (is_blank(c) || is_remark())
      return TokenKind::blank;
    if (c == ';')
      return TokenKind::semicolon;
    if (c == '?' || (c == ':' && rest_.size() > 1 && is_of_word(rest_[1])))
      return TokenKind::placeholder;
    return is_of_word(c) ? TokenKind::word : TokenKind::other;
  }

  // MariaDB runs what stands between `/*!` and `*/`.
  bool is_remark() const {
    return is_line_remark() ||
           (rest_.starts_with("/*") && !rest_.starts_with("/*!") &&
            !rest_.starts_with("/*M!"));
  }
  bool is_line_remark() const {
    return rest_.starts_with("--") || rest_.front() == '#';
  }

  std::size_t length_of(TokenKind kind) const {
    if (kind == TokenKind::blank)
      return is_line_remark() ? rest_.find('\n')
             : is_remark()    ? after("*/", 2)
                              : 1;
    if (kind == TokenKind::word || kind == TokenKind::placeholder)
      return static_cast<std::size_t>(
          std::find_if_not(rest_.begin() + 1, rest_.end(), is_of_word) -
          rest_.begin());
    const char c = rest_.front();
    // A doubled quotation mark reads as two texts side by side.
    if (c == '\'' || c == '"' || c == '`')
      return after({&c, 1}, 1);
    return 1;
  }

  std::size_t after(std::string_view mark, std::size_t from) const {
    const auto found = rest_.find(mark, from);
    return found == std::string_view::npos ? found : found + mark.size();
  }

  std::string_view rest_;
};

std::string small(std::string_view word) {
  std::string letters(word);
  for (char& c : letters)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return letters;
}

std::uint32_t lines_of(std::string_view text) {
  return static_cast<std::uint32_t>(std::count(text.begin(), text.end(), '\n'));
}

} // namespace

ScannedSql scan_sql(std::string_view sql) {
  ScannedSql scanned;
  bool ended = false;
  for (Scanner scanner(sql); !scanner.at_end();) {
    const auto token = scanner.next();
    if (token.kind == TokenKind::semicolon) {
      ended = true;
      continue;
    }
    scanned.more = scanned.more || (ended && token.kind != TokenKind::blank);
    if (ended)
      continue;
    if (token.kind != TokenKind::blank && scanned.first_word.empty())
      scanned.first_word = small(token.text);
    if (token.kind == TokenKind::placeholder)
      scanned.names.emplace_back(token.text.substr(1));
    scanned.text += token.kind == TokenKind::placeholder ? "?" : token.text;
  }
  return scanned;
}

std::vector<SqlPart> split_sql(std::string_view text) {
  std::vector<SqlPart> parts;
  const char* begin = nullptr; // of the statement
  std::uint32_t line = 1;
  std::uint32_t line_of_begin = 1;
  const auto end_at = [&](const char* end) {
    if (begin)
      parts.push_back(
          {{begin, static_cast<std::size_t>(end - begin)}, line_of_begin});
    begin = nullptr;
  };
  for (Scanner scanner(text); !scanner.at_end();) {
    const auto token = scanner.next();
    if (token.kind == TokenKind::semicolon) {
      end_at(token.text.data());
    } else if (token.kind != TokenKind::blank && !begin) {
      begin = token.text.data();
      line_of_begin = line;
    }
    line += lines_of(token.text);
  }
  end_at(text.data() + text.size());
  return parts;
}

} // namespace parlour::adapters
