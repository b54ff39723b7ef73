#include "tools/parlour/status/tail_filter.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/parlour/talk/trace.hpp"

namespace parlour::tools {

namespace {

using Json = nlohmann::json;

const char* name_of(InspectionKind kind) {
  switch (kind) {
#define X(name, sentence)                                                      \
  case InspectionKind::name:                                                   \
    return #name;
    PARLOUR_INSPECTION_KINDS(X)
#undef X
  }
  return "";
}

bool fills(const std::string& component, const std::string& role,
           const RolesByComponent& roles) {
  const auto found = roles.find(component);
  return found != roles.end() && std::ranges::count(found->second, role) > 0;
}

bool is_meant(const std::string& wanted, const std::string& name,
              const RolesByComponent& roles) {
  return wanted == name || fills(name, wanted, roles) ||
         fills(wanted, name, roles);
}

// A way such as "relay -> ASR" tells the receiver of a copy.
bool goes_to(const std::string& wanted, const Inspection& seen,
             const RolesByComponent& roles) {
  const auto arrow = seen.way.find("-> ");
  if (arrow != std::string::npos)
    return is_meant(wanted, seen.way.substr(arrow + 3), roles);
  return std::ranges::any_of(seen.message->sinks, [&](const auto& sink) {
    return is_meant(wanted, sink, roles);
  });
}

} // namespace

std::vector<std::string> inspection_kinds() {
  return {
#define X(name, sentence) #name,
      PARLOUR_INSPECTION_KINDS(X)
#undef X
  };
}

bool TailFilter::takes(const Inspection& seen,
                       const RolesByComponent& roles) const {
  if (!session.empty() && seen.session != session)
    return false;
  if (kinds.empty() ? seen.kind == InspectionKind::branch
                    : std::ranges::count(kinds, name_of(seen.kind)) == 0)
    return false;
  if (from.empty() && to.empty())
    return true;
  return seen.message &&
         (from.empty() || is_meant(from, seen.message->source, roles)) &&
         (to.empty() || goes_to(to, seen, roles));
}

std::string to_json(const TailFilter& filter) {
  const Json json = {{"session", filter.session},
                     {"kinds", filter.kinds},
                     {"from", filter.from},
                     {"to", filter.to}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Expected<TailFilter> filter_from_json(const std::string& text) {
  try {
    const auto json = Json::parse(text);
    return TailFilter{json.at("session"), json.at("kinds"), json.at("from"),
                      json.at("to")};
  } catch (const Json::exception& thrown) {
    return fail(ErrorKind::network,
                std::string("this is no filter: ") + thrown.what());
  }
}

std::string tail_line(const Inspection& seen, Timestamp now) {
  const auto time =
      seen.message && seen.message->time != 0 ? seen.message->time : now;
  return fmt::format("{}.{:03}  {}  {}  {}", format_timestamp(time, "%H:%M:%S"),
                     time % 1'000, seen.session.empty() ? "-" : seen.session,
                     seen.turn == 0 ? "-" : std::to_string(seen.turn),
                     trace_line(seen));
}

} // namespace parlour::tools
