#include "actors/routing/outcomes.hpp"

#include "runtime/message/replies.hpp"

namespace parlour::actors {

// A statement that gives no rows, such as an insert, has an empty result set.
Expected<Value> outcome_of(const Message& event) {
  if (event.command != "Result")
    return tl::make_unexpected(error_of(event, true));
  const bool has_rows = !event.params.empty() && event.params[0].if_result();
  return has_rows ? event.params[0] : Value(ResultSet{});
}

} // namespace parlour::actors
