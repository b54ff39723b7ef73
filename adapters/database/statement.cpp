#include "adapters/database/statement.hpp"

#include <cctype>

namespace parlour::adapters {

std::string first_words(std::string_view sql) {
  constexpr std::size_t most = 48;
  std::string words;
  for (char c : sql) {
    const bool blank = std::isspace(static_cast<unsigned char>(c)) != 0;
    if (blank && (words.empty() || words.back() == ' '))
      continue;
    words += blank ? ' ' : c;
    if (words.size() > most)
      break;
  }
  if (words.size() <= most)
    return "'" + words.substr(0, words.find_last_not_of(' ') + 1) + "'";
  // At a blank where there is one, never within a character.
  auto end = words.rfind(' ');
  if (end == std::string::npos || end == 0)
    for (end = most; end > 0 && (words[end] & 0xc0) == 0x80;)
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
