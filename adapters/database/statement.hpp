// What a statement of a script may do, what it answers, and the sentences that
// all databases say about one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "runtime/base/error.hpp"
#include "runtime/base/value.hpp"

namespace parlour::adapters {

enum class Access { read, write };

struct StatementAnswer {
  ResultSet rows;
  std::int64_t changes = 0; // rows inserted, updated or deleted
};

using StatementOutcome = Expected<StatementAnswer>;

// "'select staff_name from rr_staff where …'": a statement in a sentence.
std::string first_words(std::string_view sql);

// Errors of kind Refused, Refused, Database and Limit.
tl::unexpected<Error> only_reads(std::string_view sql);
tl::unexpected<Error> not_alone(std::string_view sql);
tl::unexpected<Error> no_statement();
tl::unexpected<Error> too_much(std::string_view sql, std::size_t rows,
                               std::size_t bytes);

} // namespace parlour::adapters
