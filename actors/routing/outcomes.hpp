// What the event that ends a request says: a result or an error. The one place
// where refusals of components are read.
#pragma once

#include "runtime/base/error.hpp"
#include "runtime/base/message.hpp"

namespace parlour::actors {

// What a database's event says, as an outcome: Result, Error (whose first
// parameter names a kind that scripts can catch), or the failure of the
// component.
Expected<ResultSet> outcome_of(const Message& event);
// What a database's event says that is no Result.
Error error_of(const Message& event);

} // namespace parlour::actors
