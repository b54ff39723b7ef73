// The part of supervision that says what each seat and each session has of the
// components.
#include <utility>

#include "actors/components/supervision.hpp"

namespace parlour::actors {

// -- who is there -------------------------------------------------------------

std::vector<Supervision::KeptPointer> Supervision::all_kept() const {
  std::vector<KeptPointer> all;
  for (const auto* kept : {&kept_, &coming_})
    for (const auto& [name, one] : *kept)
      all.push_back(one);
  return all;
}

void Supervision::opened(const seat_opened& what) {
  const auto place = std::make_shared<Place>(what.name, what.name);
  seats_[what.seat] = place;
  for (const auto& kept : all_kept())
    if (kept->order.upkeep.scope.kind == Scope::Kind::seat)
      branch_for(kept, place);
}

void Supervision::begins(const session_begins& what) {
  const auto seat = parts_.sessions.seat_of(what.session);
  for (const auto& kept : all_kept())
    welcome(kept, what.session, seat);
}

void Supervision::ended(const session_ended& what) {
  if (const auto seat = seats_.find(what.seat); seat != seats_.end())
    seat->second->is_over(what.session);
  for (const auto& kept : all_kept())
    take_leave(kept, what.session);
}

// -- branches -----------------------------------------------------------------

// Whoever is there gets the branch that it is to have.
void Supervision::settle(const KeptPointer& kept) {
  if (!kept->by_session) {
    branch_for(kept, house_);
    return;
  }
  if (kept->order.upkeep.scope.kind == Scope::Kind::seat)
    for (const auto& [actor, place] : seats_)
      branch_for(kept, place);
  for (const auto& [session, seat] : parts_.sessions.seats())
    welcome(kept, session, seat);
}

void Supervision::welcome(const KeptPointer& kept, const SessionId& session,
                          const seat_actor& seat) {
  if (!kept->by_session)
    return;
  auto place = std::make_shared<Place>(session, session);
  if (kept->order.upkeep.scope.kind == Scope::Kind::seat) {
    const auto found = seats_.find(seat);
    if (found == seats_.end())
      return;
    place = found->second;
    place->begins(session);
  }
  if (const auto branch = branch_for(kept, place))
    kept->by_session->put(session,
                          {branch->component->mailbox, branch->component->up});
}

// The one that it has, or a new one; null where it may have no more.
Supervision::BranchPointer
Supervision::branch_for(const KeptPointer& kept,
                        const std::shared_ptr<Place>& place) {
  const auto found = kept->branches.find(place->name());
  if (found != kept->branches.end())
    return found->second;
  if (kept->branches.size() < most_branches)
    return add_branch(kept, place);
  const auto reason = "has " + std::to_string(most_branches) +
                      " instances, as many as it may have";
  parts_.observer.log(kept->order.name + " " + reason);
  tell("ComponentDown", {kept->order.name, reason}, place->session());
  return nullptr;
}

// The one that another of its name, which it replaces or is replaced by, has at
// this place already: nothing that waits there is lost.
std::shared_ptr<ComponentMailbox>
Supervision::mailbox_at(const std::string& name, const Place& place) const {
  for (const auto& kept : all_kept())
    if (kept->order.name == name)
      if (const auto found = kept->branches.find(place.name());
          found != kept->branches.end())
        return found->second->component->mailbox;
  return std::make_shared<ComponentMailbox>();
}

// Until its instance works, its messages wait.
Supervision::BranchPointer
Supervision::add_branch(const KeptPointer& kept,
                        const std::shared_ptr<Place>& place) {
  auto branch = std::make_shared<Branch>();
  branch->place = place;
  branch->component = std::make_shared<Component>();
  branch->component->order = kept->order;
  branch->component->mailbox = mailbox_at(kept->order.name, *place);
  kept->branches[place->name()] = branch;
  *branch->component->up = is_kept(branch);
  make_missing(branch);
  return branch;
}

// What it was given before its session ended it still does.
void Supervision::take_leave(const KeptPointer& kept,
                             const SessionId& session) {
  if (!kept->by_session)
    return;
  kept->by_session->remove(session);
  auto branch = kept->branches.extract(session);
  if (!branch)
    return;
  branch.mapped()->over = true;
  depart({std::move(branch.mapped())}, {}, {});
  if (coming_.count(kept->order.name) != 0 && coming_[kept->order.name] == kept)
    came(kept);
}

} // namespace parlour::actors
