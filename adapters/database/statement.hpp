// What a statement may do, what it returns, and the error messages about
// statements that all databases share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "runtime/base/error.hpp"
#include "runtime/base/value.hpp"

namespace parlour::adapters {

// Whether a statement may change the database (language rule 11.12).
enum class Access { read, write };

struct StatementAnswer {
  ResultSet rows;
  // The number of rows that were inserted, updated or deleted.
  std::int64_t changes = 0;
};

using StatementOutcome = Expected<StatementAnswer>;

// The statement as an error message quotes it: blanks collapsed, and cut after
// about 48 bytes. "'select staff_name from rr_staff where …'"
std::string first_words(std::string_view sql);

// The errors about a statement. Their kinds are, in this order: Refused (it
// writes, but may only read), Refused (a second statement follows it), Database
// (the text has no statement), Limit (its result is too large).
tl::unexpected<Error> only_reads(std::string_view sql);
tl::unexpected<Error> not_alone(std::string_view sql);
tl::unexpected<Error> no_statement();
tl::unexpected<Error> too_much(std::string_view sql, std::size_t rows,
                               std::size_t bytes);

} // namespace parlour::adapters
