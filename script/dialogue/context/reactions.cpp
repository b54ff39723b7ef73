#include "script/dialogue/context/reactions.hpp"

namespace parlour::dialogue {

namespace {

constexpr std::string_view any = "*";

inline bool fits(const std::string& wanted, const std::string& name) {
  return wanted == name || wanted == any;
}

} // namespace

bool Reactions::Match::named() const {
  return reaction->source != any && reaction->event != any;
}

template <class Visit>
bool Reactions::visit_each(const std::vector<script::Reaction>& reactions,
                           VisitId of_state, bool captures,
                           const std::string& source, const std::string& event,
                           Visit& visit) const {
  for (const auto& reaction : reactions)
    if (fits(reaction.event, event) && is_source(reaction.source, source) &&
        !visit(Match{&reaction, of_state, captures}))
      return false;
  return true;
}

// A state with capture="all" hides the handlers also where it has no reaction
// itself (engine rule 4.4).
template <class Visit>
void Reactions::visit_matches(const std::string& source,
                              const std::string& event, Visit visit) const {
  if (const auto* active = context_.active_state()) {
    const bool captures = active->capture != script::Capture::none;
    if (!visit_each(active->messages, context_.states.visit(), captures, source,
                    event, visit) ||
        active->capture == script::Capture::all)
      return;
  }
  for (const auto& handler : context_.program->handlers)
    if ((unregistered_.empty() || !unregistered_.contains(handler.name)) &&
        !visit_each(handler.reactions, 0, false, source, event, visit))
      return;
}

// The names are compared first, as the port has to look a role up.
bool Reactions::is_source(const std::string& wanted,
                          const std::string& source) const {
  return wanted == source || wanted == any ||
         context_.port.is_source(wanted, source);
}

void Reactions::find(const std::string& source, const std::string& event,
                     std::vector<Match>& found) const {
  visit_matches(source, event, [&](const Match& match) {
    found.push_back(match);
    return true;
  });
}

std::vector<Reactions::Match>
Reactions::matches(const std::string& source, const std::string& event) const {
  std::vector<Match> found;
  find(source, event, found);
  return found;
}

bool Reactions::listens(const std::string& source,
                        const std::string& event) const {
  bool found = false;
  visit_matches(source, event, [&](const Match&) {
    found = true;
    return false;
  });
  return found;
}

bool Reactions::state_listens(const std::string& source,
                              std::string_view event) const {
  const auto* active = context_.active_state();
  if (!active)
    return false;
  bool found = active->capture != script::Capture::none;
  auto visit = [&](const Match&) {
    found = true;
    return false;
  };
  visit_each(active->messages, 0, false, source, std::string(event), visit);
  return found;
}

void Reactions::register_handler(const std::string& name, bool registered) {
  if (registered)
    unregistered_.erase(name);
  else
    unregistered_.insert(name);
}

} // namespace parlour::dialogue
