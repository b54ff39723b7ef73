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

} // namespace

Expected<ResultSet> outcome_of(const Message& event) {
  const Value first = event.params.empty() ? Value() : event.params[0];
  if (event.command == "Result") {
    if (auto rows = first.if_result())
      return *rows;
    return ResultSet{};
  }
  return tl::make_unexpected(error_of(event));
}

Error error_of(const Message& event) {
  auto reason =
      event.params.empty() ? event.command : event.params.back().text();
  return {kind_of(event).value_or(ErrorKind::database), std::move(reason), {}};
}

} // namespace parlour::actors
