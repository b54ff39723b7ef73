// Splits the text of SQL into tokens, without a database. SqlScanner knows the
// quotes, comments and placeholders of SQLite and of MariaDB (with ANSI_QUOTES
// and NO_BACKSLASH_ESCAPES), but no grammar. Where the two differ, it reads as
// the one whose dialect it is given:
//
//               SQLite               MariaDB
//   --1         a comment            two minus signs and a number
//   /*! … */    a comment            code that is run
//   [a b]       one quoted name      two brackets with words between them
//
// `#` begins a comment in both: SQLite takes no statement with that character.
//
//   for (SqlScanner scanner(sql); !scanner.at_end();)
//     use(scanner.next());
//
// The tokens, one after the other, are the whole text. No text is an error.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace parlour {

enum class SqlDialect : std::uint8_t { sqlite, mariadb };

enum class SqlTokenKind : std::uint8_t {
  blank,       // one blank, or a comment
  word,        // also a number
  quoted,      // with its marks; 'a''b' is two tokens, side by side
  placeholder, // `?` or `:name`
  semicolon,
  other // one character
};

struct SqlToken {
  SqlTokenKind kind;
  std::string_view text; // points into the text that is scanned

  // Whether the closing quotation mark of a quoted token is missing.
  bool is_open() const;
};

// Reads a text from its beginning to its end. The text must outlive the scanner
// and its tokens.
class SqlScanner {
public:
  explicit SqlScanner(std::string_view text,
                      SqlDialect dialect = SqlDialect::sqlite)
      : rest_(text), dialect_(dialect) {}

  bool at_end() const {
    return rest_.empty();
  }
  // Returns the next token. Must not be called at the end.
  SqlToken next();

private:
  SqlTokenKind kind_of_next() const;
  bool is_remark() const;
  bool is_line_remark() const;
  bool is_quote(char c) const;
  bool is_run_by_mariadb() const;
  std::size_t length_of(SqlTokenKind kind) const;
  std::size_t length_of_blank() const;
  std::size_t length_of_word() const;
  std::size_t behind(std::string_view mark, std::size_t from) const;

  std::string_view rest_;
  SqlDialect dialect_;
};

// The word with its ASCII letters in lower case, as SQL compares keywords.
std::string sql_lower(std::string_view word);

// The first token that is no blank, in lower case, such as "select". Empty if
// the text ends before, or its first statement is empty.
std::string first_sql_word(std::string_view sql,
                           SqlDialect dialect = SqlDialect::sqlite);

} // namespace parlour
