// What a component's event means to a request that waits for a reply. The one
// place where refusals of components are read.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/error.hpp"
#include "runtime/message/message.hpp"
#include "runtime/message/roles.hpp"

namespace parlour {

// Looks the event up in the roles, in order (roles.def), then in the
// component's own description. Failed is a refusal of any component. Returns
// nothing for an event that nobody describes; to a request such an event is the
// answer (language rule 12.11).
std::optional<Reply> find_reply(std::string_view event,
                                const std::vector<std::string>& roles,
                                const std::vector<RoleEvent>& own = {});

// The error that an event tells with which a component refuses a request. Who
// fills the role Database names the kind of an Error in front of its words, or
// else it is Database; of all others it is Refused (language rule 12.11).
Error error_of(const Message& event, bool is_database);
// The same, with the component's name in front of the words.
Error refusal_of(const Message& event, bool is_database);

} // namespace parlour
