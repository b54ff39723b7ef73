#include "runtime/message/replies.hpp"

#include <algorithm>
#include <utility>

namespace parlour {

namespace {

// Databases name the kind of an error in front of its words; a component that
// failed has words alone.
std::optional<ErrorKind> kind_of(const Message& event) {
  if (event.command != "Error" || event.params.size() < 2)
    return std::nullopt;
  const auto named = event.params.front().text();
#define X(kind, text, sentence)                                                \
  if (named == text)                                                           \
    return ErrorKind::kind;
  PARLOUR_ERROR_KINDS(X)
#undef X
  return std::nullopt;
}

} // namespace

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

Error error_of(const Message& event, bool is_database) {
  auto words =
      event.params.empty() ? event.command : event.params.back().text();
  const auto kind = is_database ? kind_of(event).value_or(ErrorKind::database)
                                : ErrorKind::refused;
  return {kind, std::move(words), {}};
}

Error refusal_of(const Message& event, bool is_database) {
  auto error = error_of(event, is_database);
  error.message = event.source + ": " + error.message;
  return error;
}

} // namespace parlour
