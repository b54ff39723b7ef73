// What the event that ends a query says: a result or an error.
#pragma once

#include "runtime/base/error.hpp"
#include "runtime/message/message.hpp"

namespace parlour::actors {

// What a database's event says, as an outcome: Result, Error (whose first
// parameter names a kind that scripts can catch), or the failure of the
// component. The result set is the component's own value, not a copy.
Expected<Value> outcome_of(const Message& event);

} // namespace parlour::actors
