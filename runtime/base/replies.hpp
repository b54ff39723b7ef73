// What a component's event means to a request that waits for a reply.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/roles.hpp"

namespace parlour {

// As the first of these roles that knows the event says (roles.def), then as
// the component's description of its own events does. Failed says of any
// component that it broke. Nothing where nobody says what it is: to a request
// such an event is the answer.
std::optional<Reply> find_reply(std::string_view event,
                                const std::vector<std::string>& roles,
                                const std::vector<RoleEvent>& own = {});

} // namespace parlour
