#include "adapters/database/statement.hpp"

#include <cctype>

namespace parlour::adapters {

// Collapses blanks while it copies and stops one byte after the limit, so that
// only the beginning of a long statement is read.
std::string first_words(std::string_view sql) {
  constexpr std::size_t max_length = 48;
  std::string words;
  for (char c : sql) {
    const bool blank = std::isspace(static_cast<unsigned char>(c)) != 0;
    if (blank && (words.empty() || words.back() == ' '))
      continue;
    words += blank ? ' ' : c;
    if (words.size() > max_length)
      break;
  }
  if (words.size() <= max_length)
    return "'" + words.substr(0, words.find_last_not_of(' ') + 1) + "'";
  // Cuts at the last blank. A first word longer than the limit is cut at the
  // start of a UTF-8 sequence (continuation bytes are 10xxxxxx).
  auto end = words.rfind(' ');
  if (end == std::string::npos || end == 0)
    for (end = max_length; end > 0 && (words[end] & 0xc0) == 0x80;)
      --end;
  return "'" + words.substr(0, end) + " …'";
}

tl::unexpected<Error> only_reads(std::string_view sql) {
  return fail(ErrorKind::refused,
              first_words(sql) +
                  " changes the database, but the connection only reads; "
                  "<connectdb write=\"true\"/> lets it write: with a name "
                  "wherever a query has db=\"that name\", else in the same "
                  "run of the script.");
}

tl::unexpected<Error> not_alone(std::string_view sql) {
  return fail(ErrorKind::refused,
              first_words(sql) +
                  ": one statement at a time; something follows its ';'.");
}

tl::unexpected<Error> no_statement() {
  return fail(ErrorKind::database, "There is no SQL statement to run.");
}

tl::unexpected<Error> too_much(std::string_view sql, std::size_t rows,
                               std::size_t bytes) {
  return fail(ErrorKind::limit,
              first_words(sql) + " returns more than " + std::to_string(rows) +
                  " rows or " + std::to_string(bytes) +
                  " bytes; narrow it with 'where' or 'limit'.");
}

} // namespace parlour::adapters
