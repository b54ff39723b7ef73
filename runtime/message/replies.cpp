#include "runtime/message/replies.hpp"

#include <algorithm>

namespace parlour {

std::optional<Reply> find_reply(std::string_view event,
                                const std::vector<std::string>& roles,
                                const std::vector<RoleEvent>& own) {
  for (const auto& name : roles)
    if (const auto* role = find_role(name))
      if (const auto* known = role->event(event))
        return known->reply;
  const auto described = std::ranges::find(own, event, &RoleEvent::name);
  if (described != own.end())
    return described->reply;
  if (event == "Failed")
    return Reply::refusal;
  return std::nullopt;
}

} // namespace parlour
