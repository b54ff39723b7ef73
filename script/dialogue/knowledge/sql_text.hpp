// SqlText: just enough of SQL to add conditions to a statement that an author
// wrote (engine rule 6): where its top-level clauses are, outside of quotes,
// parentheses and comments. Pure.
#pragma once

#include <string>
#include <string_view>

namespace parlour::dialogue {

// `condition` (may be empty) joined to the statement's own where, and `order`
// (may be empty) to its own order by. The conditions of a union are put around
// it, so that they hold for all of its parts. Nothing is checked: what is no
// SQL is refused by the database.
std::string with_condition(std::string_view statement,
                           std::string_view condition, std::string_view order);

// For `like … escape '!'`.
std::string escape_like(std::string_view text);

} // namespace parlour::dialogue
