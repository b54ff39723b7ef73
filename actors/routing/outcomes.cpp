#include "actors/routing/outcomes.hpp"

#include <optional>
#include <utility>

namespace parlour::actors {

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

Error error_of(const Message& event) {
  auto reason =
      event.params.empty() ? event.command : event.params.back().text();
  return {kind_of(event).value_or(ErrorKind::database), std::move(reason), {}};
}

} // namespace

Expected<Value> outcome_of(const Message& event) {
  if (event.command != "Result")
    return tl::make_unexpected(error_of(event));
  const bool has_rows = !event.params.empty() && event.params[0].if_result();
  return has_rows ? event.params[0] : Value(ResultSet{});
}

Error refusal_of(const RoutingTable& table, const Message& event) {
  auto error = error_of(event);
  if (!table.is_source("Database", event.source))
    error.kind = ErrorKind::refused;
  error.message = event.source + ": " + error.message;
  return error;
}

} // namespace parlour::actors
