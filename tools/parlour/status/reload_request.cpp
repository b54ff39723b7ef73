#include "tools/parlour/status/reload_request.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace parlour::tools {

namespace {

using Json = nlohmann::ordered_json;
using actors::ReloadMode;

constexpr std::pair<ReloadMode, const char*> modes[] = {
    {ReloadMode::keep, "keep"},
    {ReloadMode::restart, "restart"},
    {ReloadMode::new_only, "new-only"}};

template <class What, class Read>
Expected<What> from_json(const std::string& text, Read read) {
  try {
    return read(Json::parse(text));
  } catch (const Json::exception& thrown) {
    return fail(ErrorKind::network,
                std::string("what was said of a reload is not understood: ") +
                    thrown.what());
  }
}

std::string one_line(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string joined(const std::vector<std::string>& names) {
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string conversations(std::size_t count) {
  return count == 1 ? "1 conversation" : fmt::format("{} conversations", count);
}

std::string fate_of(const actors::ReloadedSessions& sessions, ReloadMode mode) {
  if (mode == ReloadMode::new_only)
    return "conversations that are going on keep the scripts that they have";
  auto text =
      conversations(sessions.gone_over) +
      (mode == ReloadMode::restart
           ? std::string(sessions.gone_over == 1 ? " begins again"
                                                 : " begin again")
           : std::string(sessions.gone_over == 1 ? " goes on" : " go on") +
                 " with the changed scripts");
  if (sessions.later > 0)
    text += fmt::format(", {} more as soon as {} at rest", sessions.later,
                        sessions.later == 1 ? "it is" : "they are");
  return text;
}

} // namespace

std::string to_json(const ReloadRequest& request) {
  const auto* const mode = std::ranges::find(
      modes, request.mode, [](const auto& one) { return one.first; });
  auto text = one_line({{"mode", mode->second}, {"undo", request.undo}});
  text.pop_back(); // it is a part of a question's line
  return text;
}

Expected<ReloadRequest> reload_request_from_json(const std::string& text) {
  return from_json<ReloadRequest>(
      text, [](const Json& json) -> Expected<ReloadRequest> {
        const std::string name = json.at("mode");
        const auto* const mode =
            std::ranges::find(modes, name, [](const auto& one) {
              return std::string(one.second);
            });
        if (mode == std::end(modes))
          return fail(ErrorKind::network, "there is no reload '" + name + "'");
        return ReloadRequest{mode->first, json.at("undo")};
      });
}

std::string to_json(const ReloadReply& reply) {
  return one_line({{"errors", reply.errors}, {"notes", reply.notes}});
}

Expected<ReloadReply> reload_reply_from_json(const std::string& text) {
  return from_json<ReloadReply>(
      text, [](const Json& json) -> Expected<ReloadReply> {
        return ReloadReply{json.at("errors"), json.at("notes")};
      });
}

std::vector<std::string> notes_of(const actors::ReloadOutcome& outcome,
                                  ReloadMode mode) {
  std::vector<std::string> notes{fate_of(outcome.sessions, mode)};
  for (const auto& [what, count] : outcome.sessions.lost)
    notes.push_back("lost: " + what + ", in " + conversations(count));
  if (!outcome.loaded.empty())
    notes.push_back("loaded: " + joined(outcome.loaded));
  if (!outcome.unloaded.empty())
    notes.push_back("unloaded: " + joined(outcome.unloaded));
  return notes;
}

} // namespace parlour::tools
