// What a component's event means to a request that waits for a reply.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/message/roles.hpp"

namespace parlour {

// Looks the event up in the roles, in order (roles.def), then in the
// component's own description. Failed is a refusal of any component. Returns
// nothing for an event that nobody describes; to a request such an event is the
// answer (language rule 12.11).
std::optional<Reply> find_reply(std::string_view event,
                                const std::vector<std::string>& roles,
                                const std::vector<RoleEvent>& own = {});

} // namespace parlour
