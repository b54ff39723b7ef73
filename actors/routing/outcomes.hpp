// What the event that ends a request says: a result or an error. The one place
// where refusals of components are read.
#pragma once

#include "actors/routing/routing_table.hpp"
#include "runtime/base/error.hpp"
#include "runtime/message/message.hpp"

namespace parlour::actors {

// What a database's event says, as an outcome: Result, Error (whose first
// parameter names a kind that scripts can catch), or the failure of the
// component. The result set is the component's own value, not a copy.
Expected<Value> outcome_of(const Message& event);
// The error that an event tells with which a component refuses a request. Of a
// database the kind is as it says; of all others, Refused.
Error refusal_of(const RoutingTable& table, const Message& event);

} // namespace parlour::actors
